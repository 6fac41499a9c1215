import type { Clock } from '@ubii/timing';
import { ConnectionError } from './connection-error.ts';
import type { Connection } from './connection.ts';
import type { Registration } from './registration.ts';

/** A credential lives for a week; one who stays for longer gets another in time, milliseconds. [AC-13] */
const CREDENTIAL_RENEWAL_MS = 24 * 3_600_000;

/** What it works with. */
export interface ProfileSyncContext {
  readonly clock: Clock;
  readonly registration: Registration;
  readonly connection: () => Pick<Connection, 'drop'>;
}

/** Tells the master name, tags and token of a client when they changed, and renews its credential. */
export class ProfileSync {
  readonly #context: ProfileSyncContext;
  /** When a new credential was asked for last, monotonic milliseconds. */
  #credentialMs: number;

  constructor(context: ProfileSyncContext) {
    this.#context = context;
    this.#credentialMs = context.clock.monotonicMs();
  }

  /** @throws {ServiceError | ConnectionError} if the master does not take it, or could not be asked */
  async tell(): Promise<void> {
    const { registration, connection } = this.#context;
    const idBefore = registration.clientId;
    await registration.update();
    if (registration.clientId === idBefore) return;
    connection().drop(
      new ConnectionError('closed', 'The master gave the client another id when it was renamed'),
    );
  }

  /** Ignores a failure: it is retried with every PING. */
  sendInBackground(): void {
    const { clock, registration } = this.#context;
    const nowMs = clock.monotonicMs();
    if (nowMs - this.#credentialMs > CREDENTIAL_RENEWAL_MS) {
      this.#credentialMs = nowMs;
      registration.renewCredential();
    }
    this.tell().catch(() => undefined);
  }
}
