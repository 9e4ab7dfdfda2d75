// `make test-widget`: JupyterLab is there already.

import base from '../../playwright.config.ts'

export default {
  ...base,
  testDir: '.',
  globalSetup: undefined,
  outputDir: '../../dist-tests',
  projects: [{ name: 'widget' }],
  use: { ...base.use, viewport: { width: 1280, height: 900 } },
}
