import { ClientState, ServiceError } from '@ubii/proto';
import type {
  Client,
  Init,
  Mark,
  ServiceName,
  ServiceReplyOf,
  ServiceRequestOf,
} from '@ubii/proto';
import { Admission } from './admission.ts';
import { ConnectionError } from './connection-error.ts';
import type { Identity } from './identity.ts';
import type { ClientProfile, Membership } from './membership.ts';
import type { SendTimes } from './send-times.ts';
import { membershipOf, registrationOf } from './registration-message.ts';
import type { IdentityStorage } from '../ports/identity-storage.ts';

/** Calls of services, as far as a registration needs them. */
export interface RegistrationCalls {
  /**
   * Calls a service.
   * @param bearer secret that identifies the caller; empty for none
   * @throws {ServiceError | ConnectionError} if the master refuses, or could not be asked
   */
  call<S extends ServiceName>(
    service: S,
    request: Init<ServiceRequestOf<S>> | undefined,
    timeoutMs?: number,
    bearer?: string,
  ): Promise<ServiceReplyOf<S>>;
  /** Rejects every open call. */
  rejectAll(error: ConnectionError): void;
}

/** What is known of the own master, and who the client is there, while another one is asked. */
interface Parked {
  readonly identity: Identity | undefined;
  readonly membership: Membership | undefined;
  readonly unverified: Membership | undefined;
}

/** Keeps the identity at the master: registers, resumes as the same client, deregisters. */
export class Registration {
  readonly #calls: RegistrationCalls;
  readonly #storage: Required<IdentityStorage>;
  #profile: ClientProfile;
  #identity: Identity | undefined;
  #membership: Membership | undefined;
  /** An earlier identity that the master has not confirmed yet. */
  #unverified: Membership | undefined;
  /** Of the own master, while another one is asked; `undefined` at the own one. [CU-83] */
  #parked: Parked | undefined;
  #hasLoaded = false;
  #clientId = '';
  /** The master has an older profile. */
  #isProfileNew = false;
  #updating: Promise<void> | undefined;
  #serial = 0;
  readonly #sendTimes: SendTimes;
  readonly #admission: Admission;

  /** @param storage does not throw, nor does what it returns reject */
  constructor(
    calls: RegistrationCalls,
    storage: Required<IdentityStorage>,
    profile: ClientProfile,
    sendTimes: SendTimes,
    joinToken?: string,
  ) {
    this.#calls = calls;
    this.#storage = storage;
    this.#profile = profile;
    this.#sendTimes = sendTimes;
    this.#admission = new Admission(
      {
        credential: () => this.credential ?? storage.loadCredential(),
        isMember: () => this.#membership !== undefined,
        dropCredential: (credential) => this.#dropCredential(credential),
      },
      joinToken,
    );
  }

  /** Identity of the client, as a master confirmed it. */
  get identity(): Identity | undefined {
    return this.#identity;
  }

  /** Credential of later requests of this client. [AC-13] */
  get credential(): string | undefined {
    return this.#identity?.credential;
  }

  /** Joins with this the next time it registers; the master learns it with `update`, too. */
  joinWith(token: string): void {
    this.#admission.joinWith(token);
    this.#isProfileNew = true;
  }

  /** Whether the token of `joinWith` was shown to the master: an attempt under way may not have known it. */
  get hasTriedToken(): boolean {
    return this.#admission.hasTriedToken;
  }

  /** Asks for a new credential with the next `update`: the one it has will end. [AC-13] */
  renewCredential(): void {
    if (this.credential !== undefined) this.#isProfileNew = true;
  }

  /** The id of this client, or the last one it had; empty before the first. */
  get clientId(): string {
    return this.#clientId;
  }

  /** Whether registering again, even twice at once, makes no second client. [CL-3] */
  get isResumable(): boolean {
    return this.#hasLoaded && this.#identity?.resumeToken !== undefined;
  }

  get profile(): ClientProfile {
    return this.#profile;
  }

  /** The current registration, as far as known; `undefined` when the client has to register. */
  get membership(): Membership | undefined {
    return this.#membership;
  }

  /**
   * Takes up the identity of an earlier run, if one was kept. Does nothing after the first time.
   * @throws {ConnectionError} if the master could not be reached
   */
  async load(): Promise<void> {
    if (this.#hasLoaded) return;
    this.#identity ??= await this.#storage.load();
    this.#hasLoaded = true;
    if (this.#identity === undefined) return;
    this.#clientId = this.#identity.clientId;
    // An earlier run of this program left its devices and subscriptions behind. Nothing here knows
    // them, so the master would send their records forever: the earlier run is ended first. [EX-7]
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
   * Makes sure that the master knows this client. Does nothing when it probably still does: a dropped
   * socket alone is no reason to register again. [EX-5]
   * @throws {ServiceError | ConnectionError} if it could not be done
   */
  async ensure(): Promise<Membership> {
    const mustTell = this.#isProfileNew && this.#membership?.isExtended === true;
    if (this.#membership !== undefined && !mustTell) return this.#membership;
    this.#serial += 1;
    const unverified = this.#unverified;
    this.#unverified = undefined;
    try {
      return await this.#register();
    } catch (error) {
      // The master did not answer. A socket may work where services do not: it is a connection of its
      // own, and theirs are kept by browsers over the end of a network.
      if (error instanceof ConnectionError) this.#membership ??= unverified;
      throw error;
    }
  }

  /** Sends requests to another master, which knows the client by id and token only. [CU-83] */
  switchTo(): void {
    this.#parked = {
      identity: this.#identity,
      membership: this.#membership,
      unverified: this.#unverified,
    };
    this.#membership = undefined;
    this.#unverified = undefined;
  }

  /** Returns to the own master with the identity there, and drops what the other one replied. */
  switchBack(): void {
    if (this.#parked === undefined) return;
    ({
      identity: this.#identity,
      membership: this.#membership,
      unverified: this.#unverified,
    } = this.#parked);
    this.#parked = undefined;
  }

  /** Makes the other master the own one, with what it replied. */
  confirmSwitch(): void {
    this.#parked = undefined;
    this.#storage.save(this.#identity);
  }

  /** Gives up what is being asked. */
  cancel(error: ConnectionError): void {
    this.#calls.rejectAll(error);
  }

  /**
   * Asks the master whether it still knows this client. One of ours says so by itself, with a close
   * code or an error code; an original one takes any socket, drops what comes over it, and gives the
   * same answer to every error.
   * @throws {ServiceError | ConnectionError} if it could not be asked
   */
  async isKnown(): Promise<boolean> {
    if (this.#membership === undefined) return false;
    const { clientId } = this.#membership.identity;
    const list = await this.#calls.call('clientGetList', { elements: [{ id: clientId }] });
    // UNAVAILABLE is final there: the topics are deleted and no PING comes any more.
    return list.elements.some(
      ({ id, state }) => id === clientId && state !== ClientState.UNAVAILABLE,
    );
  }

  /** The master does not know us any more: register again, as the same client where possible. [EX-5] */
  invalidate(): void {
    this.#membership = undefined;
    this.#unverified = undefined;
    if (this.#parked !== undefined) {
      const { identity } = this.#parked;
      this.#parked = { identity, membership: undefined, unverified: undefined };
    }
  }

  /** The master may not know us any more: ask it by registering again, if it can be asked. */
  distrust(): void {
    this.#unverified = this.#membership ?? this.#unverified;
    this.#membership = undefined;
  }

  /** The network may work again: trust the unverified membership. */
  trust(): void {
    this.#membership ??= this.#unverified;
    this.#unverified = undefined;
  }

  /** The identity is not valid any more: register as a new client. [EX-5] */
  forget(): void {
    this.#parked &&= { identity: undefined, membership: undefined, unverified: undefined };
    this.invalidate();
    this.#identity = undefined;
    this.#storage.save(undefined);
  }

  /** Changes the profile. The master learns it with `update`, or when the client registers again. */
  describe(change: Partial<ClientProfile>): void {
    this.#profile = { ...this.#profile, ...change };
    this.#isProfileNew = true;
  }

  /**
   * Tells a master of ours the profile, if it has an older one; an original master keeps what it has.
   * Registering with id and token makes no new client, and is the only way to tell. [CL-3]
   * @throws {ServiceError | ConnectionError} if it could not be done
   */
  async update(): Promise<void> {
    // One at a time, so that no older name overtakes a newer one.
    this.#updating ??= this.#registerUntilCurrent().finally(() => {
      this.#updating = undefined;
    });
    await this.#updating;
  }

  /** Leaves the master, and forgets who we were. [CL-16] */
  async deregister(timeoutMs: number): Promise<void> {
    const membership = this.#membership ?? this.#unverified ?? this.#parked?.membership;
    if (membership === undefined) return;
    const { credential } = this;
    const { clientId } = membership.identity;
    this.forget();
    await this.#calls.call('clientDeregistration', { id: clientId }, timeoutMs, credential);
  }

  async #registerUntilCurrent(): Promise<void> {
    while (this.#isProfileNew && this.#membership?.isExtended === true) await this.#register();
  }

  async #register(): Promise<Membership> {
    const profile = this.#profile;
    const message = registrationOf(profile, this.#identity, this.#sendTimes.next());
    const register = (bearer: string) =>
      this.#calls.call('clientRegistration', message, undefined, bearer);
    const client =
      this.#parked === undefined
        ? await this.#admission.admit(register)
        : await this.#registerElsewhere(register);
    if (client.id === '') {
      throw new ConnectionError(
        'protocol',
        'Expected a client id in the reply to the registration',
      );
    }
    const membership = membershipOf(client, this.#serial);
    this.#clientId = client.id;
    this.#identity = membership.identity;
    this.#membership = membership;
    this.#isProfileNew = this.#profile !== profile;
    this.#keepMark(profile, client.extension?.mark);
    if (this.#parked === undefined) this.#storage.save(this.#identity);
    return membership;
  }

  /** After a restart of the master, the client asks for the mark that it has. [EX-100] */
  #keepMark(sent: ClientProfile, mark: Mark | undefined): void {
    if (mark !== undefined && this.#profile.mark === sent.mark)
      this.#profile = { ...this.#profile, mark };
  }

  /** As the same client or not at all: the address may belong to another installation by now. [CU-83] */
  async #registerElsewhere(register: (bearer: string) => Promise<Client>): Promise<Client> {
    const client = await register(this.credential ?? '');
    if (client.id === this.#clientId) return client;
    const bearer = client.extension?.credential || undefined;
    await this.#calls.call('clientDeregistration', { id: client.id }, undefined, bearer);
    throw new ConnectionError('refused', 'The other master does not know this client');
  }

  #dropCredential(credential: string): void {
    if (this.#identity?.credential === credential) {
      const { clientId, resumeToken } = this.#identity;
      this.#identity = { clientId, resumeToken };
      this.#storage.save(this.#identity);
    }
    this.#storage.forgetCredential(credential);
  }
}
