// Serves lab/dist on a free port of 127.0.0.1 while the tests run; its address is in LAB_ADDRESS.

import { readFile } from 'node:fs/promises'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join, normalize } from 'node:path'

export const DIST = new URL('../../dist/', import.meta.url).pathname

const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.woff2': 'font/woff2',
}

export default async function serve(): Promise<() => Promise<void>> {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname))
    try {
      const bytes = await readFile(join(DIST, path === '/' ? 'index.html' : path))
      const type = TYPES[extname(path === '/' ? '.html' : path) || '.html'] ?? 'application/octet-stream'
      // A frame without an address of its own may have the files only where the server says so, as those of static pages do.
      const headers = { 'content-type': type, 'cache-control': 'max-age=3600', 'access-control-allow-origin': '*' }
      response.writeHead(200, headers).end(bytes)
    } catch {
      response.writeHead(404).end()
    }
  })
  await new Promise<void>((ready) => server.listen(0, '127.0.0.1', ready))
  process.env.LAB_ADDRESS = `http://127.0.0.1:${(server.address() as AddressInfo).port}/`
  return async () => {
    server.closeAllConnections()
    await new Promise((closed) => server.close(closed))
  }
}
