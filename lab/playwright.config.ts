// The tests of the built page in a browser: `npm run build`, then `npm run stories`; `npm run pictures` draws docs/lab/*.png.
//
// Debian's Chromium by its path, or that of CHROMIUM; nothing of Playwright's own is installed. Long time limits: a busy machine
// is no failure, and no test asserts a time.

import { existsSync } from 'node:fs'
import { defineConfig } from '@playwright/test'

const places = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome', '/snap/bin/chromium']
const chromium = process.env.CHROMIUM ?? places.find((each) => existsSync(each))
if (!chromium)
  throw new Error(`no Chromium at ${places.join(', ')}: install Debian's chromium, or give its path as CHROMIUM`)

export default defineConfig({
  testDir: 'tests/browser',
  globalSetup: './tests/browser/server.ts',
  outputDir: 'dist-tests',
  snapshotPathTemplate: '{testDir}/{testFileDir}/snapshots/{arg}{ext}',
  timeout: 900_000,
  expect: { timeout: 120_000 },
  // Each story sets what it needs, so that they go to the workers one by one, in any order.
  fullyParallel: true,
  workers: Number(process.env.LAB_WORKERS ?? 2),
  retries: 0,
  forbidOnly: true,
  reporter: [['list']],
  use: {
    browserName: 'chromium',
    headless: true,
    launchOptions: { executablePath: chromium, args: ['--no-sandbox', '--font-render-hinting=none'] },
    viewport: { width: 1280, height: 720 },
    locale: 'en-GB',
    actionTimeout: 120_000,
  },
  projects: [
    { name: 'stories', testIgnore: ['pictures.spec.ts', 'measure.spec.ts'] },
    { name: 'pictures', testMatch: 'pictures.spec.ts' },
    { name: 'measure', testMatch: 'measure.spec.ts' },
  ],
})
