/** Something that runs and has to be ended, by `dispose` when it also has something to remove. */
export interface Part {
  stop(): Promise<void>;
  dispose?(): Promise<void>;
}

/** Brokers, nodes and workers shared by the workloads of a group. Each is started on first use. */
export class SharedParts {
  readonly #parts = new Map<string, Promise<Part>>();

  /** The part of this name; the first caller starts it. */
  get<P extends Part>(name: string, start: () => Promise<P>): Promise<P> {
    let part = this.#parts.get(name);
    if (part === undefined) {
      part = start();
      this.#parts.set(name, part);
    }
    return part as Promise<P>;
  }

  /** Ends all parts, the last one first; parts that did not start have ended already. */
  async stop(): Promise<void> {
    const started = [...this.#parts.values()].reverse();
    this.#parts.clear();
    for (const part of started) await part.then(end).catch(() => undefined);
  }
}

function end(part: Part): Promise<void> {
  return part.dispose?.() ?? part.stop();
}
