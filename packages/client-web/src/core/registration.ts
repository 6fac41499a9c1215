import { ClientState, ServiceError } from '@ubii/proto';
import { ConnectionError } from './connection-error.ts';
import type { Identity } from './identity.ts';
import type { IdentityStorage } from './ports/identity-storage.ts';
import type { ServiceCalls } from './service-calls.ts';

/** What the master is told about the client. */
export interface ClientProfile {
  readonly name: string;
  readonly description: string;
  readonly tags: readonly string[];
}

/** What the master made of it. */
export interface Membership {
  readonly identity: Identity;
  /** Whether the master is one of ours and speaks the extension. [EX-1] */
  readonly isExtended: boolean;
  /** Semantic version; `undefined` for an original master. */
  readonly masterVersion: string | undefined;
}

/** Who we are at the master: registers, comes back as the same client, deregisters. */
export class Registration {
  readonly #calls: ServiceCalls;
  readonly #storage: IdentityStorage;
  #profile: ClientProfile;
  #identity: Identity | undefined;
  #membership: Membership | undefined;
  #hasLoaded = false;
  #clientId = '';
  /** The master has an older profile. */
  #isProfileNew = false;

  constructor(calls: ServiceCalls, storage: IdentityStorage, profile: ClientProfile) {
    this.#calls = calls;
    this.#storage = storage;
    this.#profile = profile;
  }

  /** The id of this client, or the last one it had; empty before the first. */
  get clientId(): string {
    return this.#clientId;
  }

  get profile(): ClientProfile {
    return this.#profile;
  }

  /** What holds as far as we know; `undefined` when the client has to register. */
  get membership(): Membership | undefined {
    return this.#membership;
  }

  /**
   * Takes up the identity of an earlier run, if one was kept. Does nothing after the first time.
   * @throws {ConnectionError} if the master could not be reached
   */
  async load(): Promise<void> {
    if (this.#hasLoaded) return;
    this.#identity ??= await this.#loadStored();
    this.#hasLoaded = true;
    if (this.#identity === undefined) return;
    this.#clientId = this.#identity.clientId;
    // An earlier run of this program left its devices and subscriptions behind. Nothing here knows
    // them, so the master would send their records for ever: the earlier run is ended first.
    try {
      await this.#calls.call('clientDeregistration', { id: this.#identity.clientId });
    } catch (error) {
      // The usual case is not_found: the master forgot it long ago.
      if (!(error instanceof ServiceError)) {
        this.#hasLoaded = false;
        throw error;
      }
    }
  }

  /**
   * Makes sure that the master knows this client: `standing` when it probably still does, because
   * a dropped socket alone is no reason to register again [EX-5], else `registered`.
   * @throws {ServiceError | ConnectionError} if it could not be done
   */
  async ensure(): Promise<'standing' | 'registered'> {
    const membership = this.#membership;
    if (membership !== undefined && !this.#isProfileNew && (await this.#isKnown(membership))) {
      return 'standing';
    }
    await this.#register();
    return 'registered';
  }

  /** The master does not know us any more: register again, as the same client where possible. [EX-5] */
  invalidate(): void {
    this.#membership = undefined;
  }

  /** The identity is of no use any more: register as a new client. [EX-5] */
  forget(): void {
    this.#membership = undefined;
    this.#identity = undefined;
    this.#save(undefined);
  }

  /**
   * Changes the name: now, when connected to a master of ours, else when the client comes back; an
   * original master learns it when it has to register the client anew.
   */
  async rename(name: string, isConnected: boolean): Promise<void> {
    this.#profile = { ...this.#profile, name };
    // Registering with id and token is no new client, and the only way to tell the master. [CL-3]
    this.#isProfileNew = this.#membership?.isExtended === true;
    if (this.#isProfileNew && isConnected) await this.#register();
  }

  /** Leaves the master, and forgets who we were. [CL-16] */
  async deregister(timeoutMs: number): Promise<void> {
    const membership = this.#membership;
    if (membership === undefined) return;
    this.forget();
    await this.#calls.call('clientDeregistration', { id: membership.identity.clientId }, timeoutMs);
  }

  async #register(): Promise<void> {
    const { name, description, tags } = this.#profile;
    const resumeToken = this.#identity?.resumeToken;
    const client = await this.#calls.call('clientRegistration', {
      name,
      ...(description === '' ? {} : { description }),
      ...(tags.length === 0 ? {} : { tags: [...tags] }),
      // An id without a token proves nothing, and an original master refuses the id of a client it still has.
      ...(resumeToken === undefined ? {} : { id: this.#identity!.clientId }),
      extension: {
        recordLists: true, // [EX-2]
        ...(resumeToken === undefined ? {} : { resumeToken }), // [EX-3]
      },
    });
    if (client.id === '') {
      throw new ConnectionError(
        'protocol',
        'Expected a client id in the reply to the registration',
      );
    }
    const { extension } = client;
    this.#clientId = client.id;
    this.#identity = { clientId: client.id, resumeToken: extension?.resumeToken || undefined };
    this.#membership = {
      identity: this.#identity,
      isExtended: extension !== undefined, // [EX-1]
      masterVersion: extension?.masterVersion || undefined,
    };
    this.#isProfileNew = false;
    this.#save(this.#identity);
  }

  /** A storage that fails costs the identity of the next run, not the connection of this one. */
  async #loadStored(): Promise<Identity | undefined> {
    try {
      return await this.#storage.load();
    } catch (error) {
      void Promise.reject(error);
      return undefined;
    }
  }

  #save(identity: Identity | undefined): void {
    try {
      this.#storage.save(identity);
    } catch (error) {
      void Promise.reject(error);
    }
  }

  /**
   * A master of ours closes the socket of a client it does not know. An original master takes any
   * socket and drops what comes over it, so it has to be asked.
   */
  async #isKnown({ identity, isExtended }: Membership): Promise<boolean> {
    if (isExtended) return true;
    const { clientId } = identity;
    const list = await this.#calls.call('clientGetList', { elements: [{ id: clientId }] });
    // UNAVAILABLE is final there: the topics are deleted and no PING comes any more.
    return list.elements.some(
      ({ id, state }) => id === clientId && state !== ClientState.UNAVAILABLE,
    );
  }
}
