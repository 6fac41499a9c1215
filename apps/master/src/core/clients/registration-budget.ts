import type { LimitWatch } from '../status/limit-watch.ts';

/** Somebody whose registrations take room. */
export interface RegistrationHolder {
  readonly id: string;
  /** Encoded bytes of what it registered. */
  registrationBytes: number;
}

/** Keeps what clients register within bounds: it stays in memory as long as they do. */
export class RegistrationBudget {
  readonly #limits: LimitWatch;
  #totalBytes = 0;

  constructor(limits: LimitWatch) {
    this.#limits = limits;
  }

  get totalBytes(): number {
    return this.#totalBytes;
  }

  /** @throws ServiceError when there is no room for `growthBytes` more. */
  require(holder: RegistrationHolder, growthBytes: number): void {
    if (growthBytes <= 0) return;
    const { registrationBytesPerClient, registrationBytes } = this.#limits.limits;
    if (holder.registrationBytes + growthBytes > registrationBytesPerClient) {
      const text = `more than ${registrationBytesPerClient} bytes registered by one client`;
      throw this.#limits.refusal('registrationBytesPerClient', text, holder.id);
    }
    if (this.#totalBytes + growthBytes > registrationBytes) {
      const text = `more than ${registrationBytes} bytes registered by all clients`;
      throw this.#limits.refusal('registrationBytes', text, holder.id);
    }
  }

  /** Takes room, or with a negative number gives it back. */
  add(holder: RegistrationHolder, bytes: number): void {
    holder.registrationBytes += bytes;
    this.#totalBytes += bytes;
  }
}
