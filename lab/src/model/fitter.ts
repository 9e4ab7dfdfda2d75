// The page's side of the fit: the module is loaded once, when it is first asked for; one worker for each fit.

import type { AskedFile, Statements, Told } from './fit-protocol'

/** An address, or a response to come. */
type ModuleSource = string | PromiseLike<Response>

export class Fitter {
  #module: Promise<WebAssembly.Module> | null = null
  #worker: Worker | null = null
  /** Tells a fit that was cancelled while the module was loading. */
  #turn = 0

  constructor(
    private readonly source: ModuleSource,
    private readonly makeWorker: () => Worker,
  ) {}

  /** Loads the module; a second call waits for the first, after a failure it is tried again. */
  load(): Promise<WebAssembly.Module> {
    this.#module ??= this.#compiled().catch((error: unknown) => {
      this.#module = null
      throw error
    })
    return this.#module
  }

  async #compiled(): Promise<WebAssembly.Module> {
    const response = await (typeof this.source === 'string' ? fetch(this.source) : this.source)
    if (!response.ok) throw new Error(`${response.status} ${response.statusText}`)
    return WebAssembly.compile(await response.arrayBuffer())
  }

  /** Reads and fits; a fit that still runs is ended first. */
  async begin(files: readonly AskedFile[], stated: Statements, listen: (told: Told) => void): Promise<void> {
    this.cancel()
    const turn = this.#turn
    const hear = (told: Told) => {
      if (turn !== this.#turn) return
      if (told.kind === 'fitted' || told.kind === 'refused' || told.kind === 'failed') this.cancel()
      listen(told)
    }
    try {
      const module = await this.load()
      if (turn !== this.#turn) return
      const worker = this.makeWorker()
      this.#worker = worker
      worker.addEventListener('message', ({ data }: MessageEvent<Told>) => hear(data))
      worker.addEventListener('error', (event) => hear({ kind: 'failed', message: event.message || 'worker' }))
      worker.postMessage({ module, files, stated })
    } catch (error) {
      hear({ kind: 'failed', message: error instanceof Error ? error.message : String(error) })
    }
  }

  /** Ends what runs; nothing more is told of it. */
  cancel(): void {
    this.#turn++
    this.#worker?.terminate()
    this.#worker = null
  }
}
