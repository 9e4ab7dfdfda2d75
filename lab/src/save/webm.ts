// The file of a film where the browser writes no H.264.

import { type OutputFormat, WebMOutputFormat } from 'mediabunny'

export const webm: (() => OutputFormat) | null = () => new WebMOutputFormat()
