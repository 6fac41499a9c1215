import type { EmptyRecord, TopicRecord } from '@ubii/proto';

const MAX_SENTENCES = 5;

/**
 * Checks the outputs of lockstep modules: every pass has one of each, in the order of the modules, with
 * the input they were given.
 */
export class PassWatch {
  readonly faults: string[] = [];
  /** Passes that are complete. */
  passes = 0;
  readonly #places: ReadonlyMap<string, number>;
  readonly #input: number;
  /** Place of the output that comes next. */
  #next = 0;
  #pass: number | undefined;

  /**
   * @param topics of the outputs, in the order of the modules
   * @param input what the modules find on their input
   */
  constructor(topics: readonly string[], input: number) {
    this.#places = new Map(topics.map((topic, place) => [topic, place]));
    this.#input = input;
  }

  /** Returns false for a record of another client. */
  handleRecord({ topic, value }: TopicRecord | EmptyRecord): boolean {
    const place = this.#places.get(topic);
    if (place === undefined) return false;
    const { x: pass, y: input } = value as { x: number; y: number };
    this.#pass ??= pass;
    if (place !== this.#next || pass !== this.#pass) {
      this.#report(
        `output ${place} of pass ${pass} where ${this.#next} of ${this.#pass} was to come`,
      );
    }
    if (input !== this.#input) this.#report(`a module found ${input} instead of ${this.#input}`);
    this.#next = place + 1;
    this.#pass = pass;
    if (this.#next < this.#places.size) return true;
    this.#next = 0;
    this.#pass += 1;
    this.passes += 1;
    return true;
  }

  #report(sentence: string): void {
    if (this.faults.length < MAX_SENTENCES) this.faults.push(`unexpected: ${sentence}`);
  }
}
