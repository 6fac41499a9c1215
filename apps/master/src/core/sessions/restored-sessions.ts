import type { Session } from './session.ts';

/** Sessions that run while the master ends, by what becomes of them [SE-24]. Names are as their makers wrote them. */
export interface SessionsAtStop {
  readonly startAgain: readonly string[];
  readonly end: readonly string[];
}

/** Results of the sessions that this master had to restart [SE-24]. */
export interface RestoreReport {
  /** Names of those whose modules all run. */
  readonly running: readonly string[];
  readonly others: readonly { readonly name: string; readonly reason: string }[];
}

const NO_REASON = 'One of its modules does not run. Open the session to see which one.';

/** Follows the sessions that the master starts at startup until each runs or is known not to. */
export class RestoredSessions {
  readonly #sessions: { readonly session: Session; readonly refusal: string | undefined }[] = [];
  #waiting: (() => void)[] = [];

  /** @param refusal why the master did not start it */
  note(session: Session, refusal?: string): void {
    this.#sessions.push({ session, refusal });
  }

  /** A session came to another state. */
  handleLife(): void {
    if (this.#isUndecided) return;
    for (const tell of this.#waiting) tell();
    this.#waiting = [];
  }

  /** Settles when none of them is starting any more, at the latest after `startTimeoutMs` [SE-12]. */
  async report(): Promise<RestoreReport> {
    if (this.#isUndecided) await new Promise<void>((resolve) => this.#waiting.push(resolve));
    const running: string[] = [];
    const others: { name: string; reason: string }[] = [];
    for (const { session, refusal } of this.#sessions) {
      const isRunning = session.life === 'running' || session.life === 'paused';
      const reason = refusal ?? session.problems()[0]?.message ?? NO_REASON;
      if (isRunning) running.push(session.label);
      else others.push({ name: session.label, reason });
    }
    return { running, others };
  }

  get #isUndecided(): boolean {
    return this.#sessions.some(({ session }) => session.life === 'starting');
  }
}
