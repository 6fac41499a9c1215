import { ServiceError } from '@ubii/proto';
import type { Init, TopicSubscription } from '@ubii/proto';
import type { Cancel, Clock } from '@ubii/timing';
import { profileToMessage } from './component-profile.ts';
import { Deferred } from '../callbacks/deferred.ts';
import { isUnknownClient } from '../connection/link-failure.ts';
import type { ServerPattern } from './topic-pattern.ts';

/** Patterns of one request. The master takes more; a smaller request is answered sooner. */
const PATTERNS_PER_REQUEST = 1_000;
/** Delay after a request that failed while connected, milliseconds. */
const RETRY_MS = 1_000;

/** Dependencies and callbacks of the synchronization. */
export interface SubscriptionSyncOptions {
  readonly clock: Clock;
  /** Calls the topic-subscription service. */
  readonly call: (request: Init<TopicSubscription>) => Promise<unknown>;
  readonly handleAccepted: (key: string) => void;
  /** The master refused the pattern; it is not wanted any more. */
  readonly handleRefused: (key: string, error: ServiceError) => void;
  /** The master does not know this client. */
  readonly handleUnknownClient: (error: ServiceError) => void;
}

interface Wanted {
  readonly pattern: ServerPattern;
  /** 0 for every record. */
  readonly maxRateHz: number;
}

interface Held extends Wanted {
  /**
   * `asked`: a request is under way, or its answer got lost · `stale`: from before a reconnect; it has
   * to be given up first, because the master sends retained records only with a new subscription.
   */
  certainty: 'certain' | 'asked' | 'stale';
}

interface Step {
  readonly subscribe: readonly Wanted[];
  readonly unsubscribe: readonly Wanted[];
}

/**
 * Brings the subscriptions the master has in line with those that are wanted: one request at a time,
 * so that none overtakes another, and everything that changed in one turn in one request.
 */
export class SubscriptionSync {
  readonly #options: SubscriptionSyncOptions;
  readonly #wanted = new Map<string, Wanted>();
  /** Subscriptions that the master has, or may have. */
  readonly #held = new Map<string, Held>();
  /** Client id of these subscriptions. */
  #clientId = '';
  /** Replaced when the link comes or goes; an answer to a request of an earlier one decides nothing. */
  #online: { readonly takesComponents: boolean; isRunning: boolean } | undefined;
  #idle: Deferred<void> | undefined;
  #cancelRetry: Cancel | undefined;

  constructor(options: SubscriptionSyncOptions) {
    this.#options = options;
  }

  /** Whether the master is known to have exactly this. */
  isAccepted(key: string): boolean {
    const held = this.#held.get(key);
    return held?.certainty === 'certain' && held.maxRateHz === this.#wanted.get(key)?.maxRateHz;
  }

  /** True while the master has the subscription or is being asked for it, at whatever rate. */
  isHeld(key: string): boolean {
    const held = this.#held.get(key);
    return this.#online !== undefined && held !== undefined && held.certainty !== 'stale';
  }

  /** @param maxRateHz 0 for every record */
  want(pattern: ServerPattern, maxRateHz: number): void {
    const held = this.#held.get(pattern.key);
    // Cancelled, and requested again before the master knew: subscribe again, for the retained records. [TD-24]
    if (held !== undefined && !this.#wanted.has(pattern.key)) held.certainty = 'stale';
    this.#wanted.set(pattern.key, { pattern, maxRateHz });
    this.#schedule();
  }

  /** Has the master send the retained records once more, which takes a new subscription. [TD-24] */
  renew(key: string): void {
    const held = this.#held.get(key);
    if (held?.certainty !== 'certain') return; // they are still to come
    held.certainty = 'stale';
    this.#schedule();
  }

  /** Resolves once the master knows, or the link is gone. */
  async unwant(key: string): Promise<void> {
    this.#wanted.delete(key);
    if (this.#online === undefined || !this.#held.has(key)) return;
    this.#schedule();
    await (this.#idle ??= new Deferred()).promise;
  }

  /**
   * The link is up: makes every subscription again, because the master may have lost them, and because
   * what was published meanwhile comes with a new subscription only [TD-24] [TD-33]. Resolves when
   * the master has all.
   * @throws {ConnectionError | ServiceError} if the link failed, or the master does not know the client
   */
  async resume(link: { clientId: string; takesComponents: boolean }): Promise<void> {
    if (link.clientId !== this.#clientId) this.#held.clear();
    this.#clientId = link.clientId;
    for (const held of this.#held.values()) held.certainty = 'stale';
    this.#online = { takesComponents: link.takesComponents, isRunning: false };
    await this.#run();
  }

  /** The link is gone: nothing is sent until `resume`. */
  pause(): void {
    this.#online = undefined;
    this.#cancelRetry?.();
    this.#cancelRetry = undefined;
    this.#becomeIdle();
  }

  /** Nothing is wanted any more, and what the master has does not matter. */
  clear(): void {
    this.pause();
    this.#wanted.clear();
    this.#held.clear();
  }

  #schedule(): void {
    if (this.#online === undefined || this.#online.isRunning) return;
    // In a turn of its own, so that everything asked for in this one travels together.
    void Promise.resolve()
      .then(() => this.#run())
      .catch(this.#handleFailure);
  }

  readonly #handleFailure = (error: unknown): void => {
    if (this.#online === undefined) return;
    if (error instanceof ServiceError) {
      this.#options.handleUnknownClient(error);
      return;
    }
    this.#cancelRetry?.();
    this.#cancelRetry = this.#options.clock.after(RETRY_MS, () => this.#schedule());
  };

  async #run(): Promise<void> {
    const online = this.#online;
    if (online === undefined || online.isRunning) return;
    online.isRunning = true;
    try {
      for (let steps = this.#plan(); steps.length > 0; steps = this.#plan()) {
        for (const step of steps) {
          await this.#perform(step);
          if (this.#online !== online) return;
        }
      }
    } finally {
      online.isRunning = false;
    }
    this.#becomeIdle();
  }

  /** Returns the requests that turn the held subscriptions into the wanted ones. */
  #plan(): Step[] {
    const stale = [...this.#held.values()].filter(({ certainty }) => certainty === 'stale');
    if (stale.length > 0) return chunks(stale).map(toUnsubscribe);
    const byRate = new Map<number, Wanted[]>();
    for (const wanted of this.#wanted.values()) {
      if (this.isAccepted(wanted.pattern.key)) continue;
      // A rate belongs to a request and not to a pattern. [EX-8]
      const sameRate = byRate.get(wanted.maxRateHz);
      if (sameRate === undefined) byRate.set(wanted.maxRateHz, [wanted]);
      else sameRate.push(wanted);
    }
    const surplus = [...this.#held.values()].filter(
      ({ pattern }) => !this.#wanted.has(pattern.key),
    );
    return [
      ...[...byRate.values()].flatMap((wanted) => chunks(wanted).map(toSubscribe)),
      ...chunks(surplus).map(toUnsubscribe),
    ];
  }

  async #perform(step: Step): Promise<void> {
    for (const wanted of step.subscribe) {
      // Noted before the request: should the answer get lost, the master may have it anyway.
      this.#held.set(wanted.pattern.key, { ...wanted, certainty: 'asked' });
    }
    const online = this.#online;
    try {
      const request = toRequest(step, online?.takesComponents === true);
      if (request !== undefined) await this.#options.call(request);
    } catch (error) {
      if (!(error instanceof ServiceError) || isUnknownClient(error)) throw error;
      await this.#handleRefusal(step, error);
      return;
    }
    if (this.#online !== online) return;
    for (const { pattern } of step.unsubscribe) this.#held.delete(pattern.key);
    for (const { pattern } of step.subscribe) {
      const held = this.#held.get(pattern.key);
      if (held !== undefined) held.certainty = 'certain';
      if (this.#wanted.has(pattern.key)) this.#options.handleAccepted(pattern.key);
    }
  }

  async #handleRefusal(step: Step, error: ServiceError): Promise<void> {
    if (step.subscribe.length + step.unsubscribe.length > 1) {
      // One entry is refused: send each alone to find out which.
      for (const one of step.subscribe) await this.#perform(toSubscribe([one]));
      for (const one of step.unsubscribe) await this.#perform(toUnsubscribe([one]));
      return;
    }
    for (const { pattern } of [...step.subscribe, ...step.unsubscribe]) {
      this.#held.delete(pattern.key);
      if (step.subscribe.length === 0) continue;
      this.#wanted.delete(pattern.key);
      this.#options.handleRefused(pattern.key, error);
    }
  }

  #becomeIdle(): void {
    this.#idle?.resolve();
    this.#idle = undefined;
  }
}

function toSubscribe(subscribe: readonly Wanted[]): Step {
  return { subscribe, unsubscribe: [] };
}

function toUnsubscribe(unsubscribe: readonly Wanted[]): Step {
  return { subscribe: [], unsubscribe };
}

/** `undefined` when there is nothing to ask: component profiles are only for masters that take them. [TD-27] */
function toRequest(step: Step, takesComponents: boolean): Init<TopicSubscription> | undefined {
  const subscribe = toMembers(step.subscribe, takesComponents);
  const unsubscribe = toMembers(step.unsubscribe, takesComponents);
  const maxRateHz = step.subscribe[0]?.maxRateHz ?? 0;
  const request: Init<TopicSubscription> = {
    ...(subscribe.topics.length > 0 ? { subscribeTopics: subscribe.topics } : {}),
    ...(subscribe.sources.length > 0 ? { subscribeTopicRegexp: subscribe.sources } : {}),
    ...(subscribe.components.length > 0 ? { subscribeComponents: subscribe.components } : {}),
    ...(unsubscribe.topics.length > 0 ? { unsubscribeTopics: unsubscribe.topics } : {}),
    ...(unsubscribe.sources.length > 0 ? { unsubscribeTopicRegexp: unsubscribe.sources } : {}),
    ...(unsubscribe.components.length > 0 ? { unsubscribeComponents: unsubscribe.components } : {}),
  };
  if (Object.keys(request).length === 0) return undefined;
  return maxRateHz > 0 ? { ...request, maxRateHz } : request;
}

function toMembers(wanted: readonly Wanted[], takesComponents: boolean) {
  const topics: string[] = [];
  const sources: string[] = [];
  const components: ReturnType<typeof profileToMessage>[] = [];
  for (const { pattern } of wanted) {
    if (pattern.kind === 'topic') topics.push(pattern.topic);
    else if (pattern.kind === 'regex') sources.push(pattern.source);
    else if (takesComponents) components.push(profileToMessage(pattern.profile));
  }
  return { topics, sources, components };
}

function chunks<T>(all: readonly T[]): T[][] {
  const result: T[][] = [];
  for (let i = 0; i < all.length; i += PATTERNS_PER_REQUEST) {
    result.push(all.slice(i, i + PATTERNS_PER_REQUEST));
  }
  return result;
}
