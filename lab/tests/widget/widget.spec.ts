// The widget in a real JupyterLab: it draws, a key on a slider reaches Python, Python reaches the drawing, and nothing else is asked for.
//
// JUPYTER is the address of the server with its token, and PICTURE where the page is photographed (`make test-widget`).

import { expect, type Page, test } from '@playwright/test'

const jupyter = process.env.JUPYTER
if (!jupyter) throw new Error('JUPYTER: the address of JupyterLab; `make test-widget` starts one')
const { origin, searchParams } = new URL(jupyter)

/** Puts code into the first cell that is empty, at the end, and runs it. */
async function run(page: Page, code: string): Promise<void> {
  const cell = page.locator('.jp-Notebook .jp-CodeCell').last()
  await cell.locator('.cm-content').click()
  await page.keyboard.insertText(code)
  await page.keyboard.press('Shift+Enter')
}

const outputs = (page: Page) => page.locator('.jp-OutputArea-output')

test('a pendulum shows itself, and its sliders write to Python', async ({ page }) => {
  const elsewhere: string[] = []
  page.on('request', (request) => {
    const address = request.url()
    if (
      !address.startsWith(origin) &&
      /^(https?|wss?):/.test(address) &&
      !address.startsWith(origin.replace('http', 'ws'))
    )
      elsewhere.push(address)
  })
  await page.goto(`${origin}/lab/tree/pendulum.ipynb?token=${searchParams.get('token')}`)
  await page.locator('.jp-Notebook .jp-CodeCell').first().waitFor()
  // A narrow status bar hides its words.
  await page.getByText('Idle').first().waitFor({ state: 'attached' })

  await run(page, 'from libration import Pendulum\nPendulum(2.0, length=1.0)')
  const drawn = page.locator('.widget', { has: page.locator('.bob-drawing') })
  await expect(drawn).toHaveCount(1)
  await expect(drawn.locator('.bob-handle')).toBeVisible()
  await expect(drawn.locator('#period-value')).toHaveText(/2\.6/)

  await run(page, 'widget = Pendulum(2.0, length=1.0).widget(lang="en")\nwidget')
  const widget = drawn.nth(1)
  const slider = (name: string) => widget.locator(`[data-value="${name}"] [role="slider"]`)
  await slider('theta0').focus()
  await page.keyboard.press('Home')
  await page.keyboard.press('PageUp')
  await slider('length').focus()
  await page.keyboard.press('End')
  await expect(widget.locator('[data-value="length"] input')).toHaveValue('2')
  await run(page, 'import math\nprint("now", round(math.degrees(widget.theta0), 9), widget.pendulum.length)')
  await expect(outputs(page).filter({ hasText: 'now' }).last()).toHaveText(/now -170\.0 2\.0/)

  await run(page, 'widget.theta0 = 0.5\nwidget.length = 0.25\nprint("set", widget.pendulum)')
  await expect(widget.locator('[data-value="theta0"] input')).toHaveValue(/28\.6/)
  await expect(widget.locator('[data-value="length"] input')).toHaveValue('0.25')

  await run(page, 'by_frequency = Pendulum(3.0, omega0=2.0).widget(lang="es")\nby_frequency')
  const other = drawn.nth(2)
  await other.locator('[data-value="omega0"] [role="slider"]').focus()
  await page.keyboard.press('ArrowRight')
  await run(page, 'print("omega0", by_frequency.pendulum.omega0)')
  await expect(outputs(page).filter({ hasText: 'omega0' }).last()).toHaveText(/omega0 2\.1/)
  await expect(other.locator('.sentence')).toContainText('péndulo')

  await drawn.nth(1).scrollIntoViewIfNeeded()
  if (process.env.PICTURE) await page.screenshot({ path: process.env.PICTURE })
  expect(elsewhere).toEqual([])
})
