import type { Cancel, Clock } from '@ubii/timing';
import type { RandomSource } from '../ports/random.ts';
import type { Outage } from './connection-model.ts';
import type { ConnectionState } from './connection-state.ts';
import type { ProofUnderWay } from './master-proof.ts';
import type { Masters } from './masters.ts';
import { atDeadline } from '../time/deadline.ts';
import { reconnectDelayMs, type ReconnectPolicy } from './reconnect-policy.ts';

/** The own master is gone for this long before another one is asked, milliseconds. [CU-81] */
const PATIENCE_MS = 2_000;
/** Chance adds up to this, so that the clients of one master do not come to the others in one instant, milliseconds. */
const SPREAD_MS = 1_000;
/**
 * Time in which another master has to answer, milliseconds. Doubled each time that none did: a master to which many come at
 * once is slow, and those who ask again before it answered make it slower. [CU-81]
 */
const FIRST_ANSWER_MS = 2_000;
const MAX_ANSWER_MS = 16_000;

/** Dependencies of a scout. */
export interface ScoutOptions {
  readonly clock: Clock;
  readonly random: RandomSource;
  readonly policy: ReconnectPolicy;
  readonly masters: Masters;
  readonly outage: () => Outage | undefined;
  /** Asks another master to prove that it is of the cluster. [CU-85] */
  readonly ask: (url: string) => ProofUnderWay;
  /** Another master is there: so the network is, and the own master is asked at once. */
  readonly recheck: () => void;
  readonly switchTo: (url: string) => void;
}

/**
 * Looks for another master while the own one does not answer. It goes there only when the own one, asked again after
 * the other one answered, still does not: else it would be the network that was gone, and not the master. [CU-82]
 */
export class Scout {
  readonly #options: ScoutOptions;
  /** Still to be asked in this round. */
  #round: string[] = [];
  #rounds = 0;
  #hasVisited = false;
  #answerMs = FIRST_ANSWER_MS;
  #answering: { readonly url: string; readonly sinceMs: number } | undefined;
  #cancel: Cancel | undefined;

  constructor(options: ScoutOptions) {
    this.#options = options;
  }

  /** To be called after each change of the state. */
  handleState({ status }: ConnectionState): void {
    const outage = status === 'reconnecting' ? this.#options.outage() : undefined;
    if (outage === undefined) return this.#rest();
    const answering = this.#answering;
    if (answering === undefined) {
      if (this.#cancel === undefined) this.#start(outage);
    } else if (outage.failedStartMs !== undefined && outage.failedStartMs >= answering.sinceMs) {
      this.#answering = undefined;
      this.#hasVisited = true;
      this.#options.switchTo(answering.url);
    }
  }

  #rest(): void {
    this.#cancel?.();
    this.#cancel = undefined;
    this.#answering = undefined;
    this.#round = [];
    this.#rounds = 0;
    this.#hasVisited = false;
    this.#answerMs = FIRST_ANSWER_MS;
  }

  #start({ sinceMs }: Outage): void {
    const { clock, random } = this.#options;
    if (this.#hasVisited) return this.#askAfter(this.#pauseMs()); // one that was no use
    const leftMs = Math.max(0, sinceMs + PATIENCE_MS - clock.monotonicMs());
    this.#askAfter(leftMs + random() * SPREAD_MS);
  }

  #askAfter(delayMs: number): void {
    this.#cancel = this.#options.clock.after(delayMs, () => this.#askNext());
  }

  #askNext(): void {
    this.#cancel = undefined;
    const url = this.#next();
    if (url === undefined) return;
    const { ask, clock } = this.#options;
    const asked = ask(url);
    let isOver = false;
    const finish = (isProven: boolean): void => {
      if (isOver) return;
      isOver = true;
      cancelTimer();
      this.#cancel = undefined;
      if (isProven) this.#handleAnswer(url);
      else this.#askAfter(this.#pauseMs());
    };
    const cancelTimer = atDeadline(clock, this.#answerMs, () => {
      this.#answerMs = Math.min(2 * this.#answerMs, MAX_ANSWER_MS);
      asked.cancel();
      finish(false);
    });
    this.#cancel = () => {
      isOver = true;
      cancelTimer();
      asked.cancel();
    };
    void asked.isProven.then(finish);
  }

  #handleAnswer(url: string): void {
    this.#answering = { url, sinceMs: this.#options.clock.monotonicMs() };
    this.#options.recheck();
  }

  /** Each round is in another order: so the clients of one master spread over all the others. [CU-84] */
  #next(): string | undefined {
    const { masters, random } = this.#options;
    if (this.#round.length === 0) {
      this.#rounds++;
      this.#round = shuffled(masters.others, random);
    }
    return this.#round.pop();
  }

  /** Longer with each round. */
  #pauseMs(): number {
    const { policy, random } = this.#options;
    const rounds = Math.max(0, this.#rounds - 1);
    return reconnectDelayMs({ ...policy, giveUpAfterAttempts: Infinity }, rounds, random)!;
  }
}

function shuffled(all: readonly string[], random: RandomSource): string[] {
  const left = [...all];
  const result: string[] = [];
  while (left.length > 0) result.push(...left.splice(Math.floor(random() * left.length), 1));
  return result;
}
