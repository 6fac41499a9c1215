import type { Client } from '@ubii/proto';
import { joinProblemOf, sendableToken, wrongToken } from './join.ts';

/** State of the client that an admission needs. */
export interface Applicant {
  /** The credential of this client, or else that of an earlier client here. */
  credential(): string | undefined;
  /** Whether the master knows the client already. */
  isMember(): boolean;
  /** The master takes this credential no more. */
  dropCredential(credential: string): void;
}

/** Registers with a secret that identifies the caller; empty for none. */
type Register = (bearer: string) => Promise<Client>;

/** Chooses the secret with which a client is admitted. */
export class Admission {
  readonly #applicant: Applicant;
  /** Token or code to join with, until the client has joined. */
  #joinToken: string | undefined;
  /** Entered by the user just now: report when it is not valid. */
  #isTokenAsked = false;
  #hasTriedToken = false;

  constructor(applicant: Applicant, joinToken: string | undefined) {
    this.#applicant = applicant;
    this.#joinToken = joinToken;
  }

  /** Joins with this the next time. */
  joinWith(token: string): void {
    this.#joinToken = token;
    this.#isTokenAsked = true;
    this.#hasTriedToken = false;
  }

  /** Whether the token of `joinWith` was shown to the master. */
  get hasTriedToken(): boolean {
    return this.#hasTriedToken;
  }

  /**
   * Registers with the first available secret: the given token, the credential of the client, that of
   * an earlier client here, else nothing, which is enough on the master's own machine. [AC-3] [AC-23]
   */
  async admit(register: Register): Promise<Client> {
    const credential = this.#applicant.credential();
    const hasToken = this.#joinToken !== undefined;
    try {
      if (hasToken) return await this.#joinByToken(register, credential);
      return await register(credential ?? '');
    } catch (error) {
      const problem = joinProblemOf(error);
      const isRefused = problem !== undefined && problem !== 'role';
      if (hasToken || credential === undefined || !isRefused) throw error;
      this.#applicant.dropCredential(credential);
      // Of why it is worth nothing more can be told than that nothing was shown.
      return await register('').catch((again: unknown) =>
        Promise.reject((joinProblemOf(again) === 'missing' ? error : again) as Error),
      );
    }
  }

  async #joinByToken(register: Register, credential: string | undefined): Promise<Client> {
    const joinToken = this.#joinToken!;
    const isAsked = this.#isTokenAsked;
    this.#hasTriedToken = true;
    const sendable = sendableToken(joinToken);
    let client: Client;
    try {
      if (sendable === undefined) throw wrongToken();
      client = await register(sendable);
    } catch (error) {
      if (joinProblemOf(error) === undefined) throw error;
      // A typed code is not retried automatically.
      if (isAsked && this.#joinToken === joinToken && this.#applicant.isMember()) {
        this.#joinToken = undefined;
      }
      // A client that has joined stays joined when its user opens the same old link again.
      if (isAsked || credential === undefined) throw error;
      client = await register(credential).catch(() => Promise.reject(error as Error));
    }
    if (this.#joinToken === joinToken) this.#joinToken = undefined;
    return client;
  }
}
