import type { Init, Replay, ReplayChangeRequest } from '@ubii/proto';

/** A change of a replay; later members replace earlier ones. */
export type ReplayChange = Omit<Init<ReplayChangeRequest>, 'id'>;

/** Changes a replay, one request at a time: what is wished meanwhile goes into the next one. */
export class ReplayControl {
  readonly #call: (change: ReplayChange) => Promise<Replay | undefined>;
  #waiting: ReplayChange | undefined;
  #isBusy = false;

  /** @param call does not reject */
  constructor(call: (change: ReplayChange) => Promise<Replay | undefined>) {
    this.#call = call;
  }

  /** Whether a change is on its way, so that news of the replay may be older. */
  get isBusy(): boolean {
    return this.#isBusy;
  }

  change(change: ReplayChange): void {
    this.#waiting = { ...this.#waiting, ...change };
    if (!this.#isBusy) void this.#run();
  }

  async #run(): Promise<void> {
    this.#isBusy = true;
    while (this.#waiting !== undefined) {
      const next = this.#waiting;
      this.#waiting = undefined;
      await this.#call(next);
    }
    this.#isBusy = false;
  }
}
