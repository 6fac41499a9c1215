/** Where the records of a topic came from when they were recorded. */
export interface RecordedSource {
  /** Id of the publisher; empty when it is not known. */
  readonly clientId: string;
  /** Id of the device that had the component; empty when it is not known. */
  readonly deviceId: string;
}

/** Topics of sessions that run again: modules on the master see the recorded publishers there, not the replay. [RP-43] */
export class RecordedSources {
  readonly #sources = new Map<string, RecordedSource>();

  /** Undefined for live topics, which are looked up in no table while no session runs again. */
  get(topic: string): RecordedSource | undefined {
    return this.#sources.size === 0 ? undefined : this.#sources.get(topic);
  }

  add(topic: string, source: RecordedSource): void {
    this.#sources.set(topic, source);
  }

  delete(topic: string): void {
    this.#sources.delete(topic);
  }
}
