// The worker of the fit: the page never waits for it, and ends it to cancel.

import { type Asked, measure, type Told } from './fit-protocol'

self.addEventListener('message', ({ data }: MessageEvent<Asked>) => {
  void measure(data, (told: Told) => self.postMessage(told))
})
