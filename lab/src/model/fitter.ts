// The page's side of the fit: each module is loaded once, when it is first asked for; one worker for each fit.

import type { AskedFile, Statements, Told } from './fit-protocol'

/** An address, or a response to come. */
type ModuleSource = string | PromiseLike<Response>

/** What the view Data may ask for: two modules for a file, one for a period. */
type ModuleName = 'reader' | 'fit' | 'period'

export class Fitter {
  readonly #modules: Partial<Record<ModuleName, Promise<WebAssembly.Module>>> = {}
  #worker: Worker | null = null
  /** Tells a fit that was cancelled while the modules were loading. */
  #turn = 0

  constructor(
    private readonly sources: Readonly<Record<ModuleName, ModuleSource>>,
    private readonly makeWorker: () => Worker,
    /** Called when a module has come. */
    private readonly came: () => void = () => {},
    /** When what a worker tells is heard. */
    private readonly heard: (hear: () => void) => void = (hear) => hear(),
  ) {}

  /** Loads a module; a second call waits for the first, after a failure it is tried again. */
  load(name: ModuleName): Promise<WebAssembly.Module> {
    const loading = this.#modules[name] ?? this.#compiled(name)
    this.#modules[name] = loading
    return loading
  }

  async #compiled(name: ModuleName): Promise<WebAssembly.Module> {
    try {
      const source = this.sources[name]
      const response = await (typeof source === 'string' ? fetch(source) : source)
      if (!response.ok) throw new Error(`${response.status} ${response.statusText}`)
      const module = await WebAssembly.compile(await response.arrayBuffer())
      this.came()
      return module
    } catch (error) {
      delete this.#modules[name]
      throw error
    }
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
      const [reader, fit] = await Promise.all([this.load('reader'), this.load('fit')])
      if (turn !== this.#turn) return
      const worker = this.makeWorker()
      this.#worker = worker
      worker.addEventListener('message', ({ data }: MessageEvent<Told>) => this.heard(() => hear(data)))
      worker.addEventListener('error', (event) => hear({ kind: 'failed', message: event.message || 'worker' }))
      worker.postMessage({ modules: { reader, fit }, files, stated })
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
