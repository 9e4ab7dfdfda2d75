// In the offline file, which would be a fiftieth longer: there the film is an MP4 or a GIF (bundle/one-file.ts).

import type { OutputFormat } from 'mediabunny'

export const webm: (() => OutputFormat) | null = null
