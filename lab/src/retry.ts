// A part of the page that does not come is asked for again: a network fails for a moment, and the browser may end the service
// worker while it answers, which loses the answer.

/** Pauses before it is asked for again, in ms. */
const PAUSES = [200, 1000]

/** What comes at the first try that does not fail; the failure of the last. */
export async function retried<T>(ask: () => Promise<T>): Promise<T> {
  for (const pause of PAUSES) {
    try {
      return await ask()
    } catch {
      await new Promise((done) => setTimeout(done, pause))
    }
  }
  return ask()
}
