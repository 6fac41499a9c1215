import type { MasterAt, WaysTo } from '../ports/master-ways.ts';
import type { ServiceTransport } from '../ports/service-transport.ts';
import type { TopicDataTransport } from '../ports/topic-data-transport.ts';

/** A cluster has fewer masters, and a master fewer addresses; no more are tried. */
const MAX_ADDRESSES = 64;
const MAX_CHARACTERS = 200;

/**
 * Returns the announced addresses of masters that a client can use. [CU-80]
 * @param ownUrl of the master that announced them
 * @returns each once, without a slash at the end
 */
export function usableMasters(
  announced: readonly string[],
  ownUrl: string | undefined,
): readonly string[] {
  const own = parse(ownUrl ?? '');
  if (own === undefined) return [];
  const usable = new Set<string>();
  for (const text of announced.slice(0, MAX_ADDRESSES).flatMap(waysTo)) {
    const url = parse(text);
    // What shows who the client is never goes unencrypted when it came encrypted.
    if (url === undefined || (own.protocol === 'https:' && url.protocol !== 'https:')) continue;
    // For a client of another machine, the address of a machine for itself is that of its own.
    if (isOfThisMachine(url) && !isOfThisMachine(own)) continue;
    if (baseOf(url) !== baseOf(own)) usable.add(baseOf(url));
  }
  return [...usable];
}

/** A master has HTTP on the port of HTTPS: there, a client that came by HTTP needs no certificate that it trusts. */
function waysTo(text: string): readonly string[] {
  const [, rest] = /^https(:\/\/[^/?#]+:\d+\/?)$/.exec(text) ?? [];
  return rest === undefined ? [text] : [text, `http${rest}`];
}

function parse(text: string): URL | undefined {
  if (text.length > MAX_CHARACTERS) return undefined;
  try {
    const url = new URL(text);
    return /^https?:$/.test(url.protocol) && url.username === '' ? url : undefined;
  } catch {
    return undefined;
  }
}

function baseOf({ origin, pathname }: URL): string {
  return `${origin}${pathname}`.replace(/\/+$/, '');
}

/** Loopback, and the unspecified address, which connects to the machine that asks. `URL` writes addresses in one way only. */
function isOfThisMachine({ hostname }: URL): boolean {
  return /^(127(\.\d+){3}|0\.0\.0\.0|\[::1?\]|\[::ffff:(7f[\da-f]{2}:[\da-f]+|0:0)\]|localhost|.*\.localhost)$/.test(
    hostname,
  );
}

/** The own master of a client, those that it announced, and the one that requests and sockets go to now. [CU-80] */
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
  #announced: readonly string[] = [];

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
    return this.#waysTo === undefined ? [] : usableMasters(this.#announced, this.#own.url);
  }

  /** The own master tells of others: of these alone from now on. [CU-80] */
  learn(addresses: readonly string[]): void {
    this.#announced = addresses;
  }

  /** Ways to one of the others, to ask it something. */
  at(url: string): MasterAt {
    return { url, ...this.#waysTo!(url) };
  }

  /** Requests and sockets go to another master from now on. */
  switchTo(url: string): void {
    this.#current = this.at(url);
  }

  /** They go to the own one again. */
  switchBack(): void {
    this.#current = this.#own;
  }

  /** The other one is the own one from now on. */
  confirmSwitch(): void {
    this.#own = this.#current;
  }
}
