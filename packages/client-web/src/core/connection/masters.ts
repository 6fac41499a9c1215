import type { MasterAt, WaysTo } from '../ports/master-ways.ts';
import type { ServiceTransport } from '../ports/service-transport.ts';
import type { TopicDataTransport } from '../ports/topic-data-transport.ts';
import { usableMasters } from './usable-masters.ts';

/** The own master of a client, those that it told of, and the one that requests and sockets go to now. [CU-80] */
export class Masters {
  /** Leads to the master of this moment. */
  readonly services: ServiceTransport = {
    send: (request, bearer) => this.#current.services.send(request, bearer),
  };
  /** Leads to the master of this moment. */
  readonly topicData: TopicDataTransport = {
    open: (query, handler) => this.#current.topicData.open(query, handler),
  };
  readonly #waysTo: WaysTo | undefined;
  #own: MasterAt;
  #current: MasterAt;
  #told: readonly string[] = [];

  /** @param waysTo without it, the client stays where it is */
  constructor(own: MasterAt, waysTo: WaysTo | undefined) {
    this.#own = own;
    this.#current = own;
    this.#waysTo = waysTo;
  }

  /** Base URL of the own master; `undefined` when only the ways to it are known. */
  get url(): string | undefined {
    return this.#own.url;
  }

  /** Where the client can go when its own master is gone; of each master the best first. */
  get others(): readonly string[] {
    return this.#waysTo === undefined ? [] : usableMasters(this.#told, this.#own.url);
  }

  /** The own master tells of others: of these alone from now on. [CU-80] */
  learn(addresses: readonly string[]): void {
    this.#told = addresses;
  }

  /** Ways to one of the others, to ask it something. */
  at(url: string): MasterAt {
    return { url, ...this.#waysTo!(url) };
  }

  /** Requests and sockets go to another master from now on. */
  visit(url: string): void {
    this.#current = this.at(url);
  }

  /** They go to the own one again. */
  leave(): void {
    this.#current = this.#own;
  }

  /** The other one is the own one from now on. */
  keep(): void {
    this.#own = this.#current;
  }
}
