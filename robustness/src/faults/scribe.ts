import { AccessRole } from '@ubii/proto';

import { ticking } from '../fixtures/sessions.ts';
import type { Random } from '../random.ts';
import type { Ask, Ledger } from './ledger.ts';

const MOST_SESSIONS = 40;
const MOST_GRANTS = 40;
const MOST_RUNNING = 3;

/** Does what a host does over an hour, and writes down what was acknowledged. */
export class Scribe {
  readonly #random: Random;
  readonly #ledger: Ledger;
  readonly #ask: Ask;
  /** Characters of what sessions say: how quickly a disk is full. */
  readonly #textLength: number;
  #count = 0;
  acknowledged = 0;
  refused = 0;
  /** Why the last request that was not acknowledged was not. */
  lastRefusal = '';

  constructor(random: Random, ledger: Ledger, ask: Ask, textLength = 200) {
    this.#random = random;
    this.#ledger = ledger;
    this.#ask = ask;
    this.#textLength = textLength;
  }

  /** Does one thing. @returns false when the master refused it or gave no answer */
  turn(): Promise<boolean> {
    return this.#book(this.#choose());
  }

  /** Stores one more session, whatever there is. @returns as above */
  save(): Promise<boolean> {
    return this.#book(this.#save());
  }

  async #book(doing: Promise<boolean>): Promise<boolean> {
    const isDone = await doing;
    if (isDone) this.acknowledged++;
    else this.refused++;
    return isDone;
  }

  #choose(): Promise<boolean> {
    const { sessions, grants, running } = this.#ledger;
    const stored = [...sessions.values()].filter(({ isThere }) => isThere === true);
    const good = [...grants.values()].filter(({ isGood }) => isGood === true);
    if (running.size < MOST_RUNNING && this.#random.oneIn(4)) return this.#start();
    switch (this.#random.below(6)) {
      case 0:
      case 1:
        return good.length < MOST_GRANTS ? this.#grant() : this.#revoke(this.#random.pick(good).id);
      case 2:
        return good.length > 4 ? this.#revoke(this.#random.pick(good).id) : this.#grant();
      case 3:
        if (stored.length > 4) return this.#change(this.#random.pick(stored).name);
        return this.#save();
      case 4:
        if (stored.length > 8) return this.#delete(this.#random.pick(stored).name);
        return this.#save();
      default:
        return stored.length < MOST_SESSIONS
          ? this.#save()
          : this.#delete(this.#random.pick(stored).name);
    }
  }

  #text(): string {
    return `${this.#count}: `.padEnd(this.#textLength, 'x');
  }

  async #save(): Promise<boolean> {
    const name = `session ${++this.#count}`;
    const description = this.#text();
    const reply = await this.#tryAsk({
      topic: '/services/session/database/save',
      session: { ...ticking(name, `/${name}`), description },
    });
    if (reply?.sessionList === undefined) return false;
    this.#ledger.sessions.set(name, { name, texts: [description], isThere: true });
    return true;
  }

  async #change(name: string): Promise<boolean> {
    const kept = this.#ledger.sessions.get(name)!;
    this.#count++;
    const description = this.#text();
    const before = kept.texts;
    kept.texts = [...before, description];
    const reply = await this.#tryAsk({
      topic: '/services/session/database/save',
      session: { ...ticking(name, `/${name}`), description },
    });
    if (reply?.sessionList !== undefined) kept.texts = [description];
    // Refused by the master itself: what was there stands. Without an answer it may be either.
    else if (reply !== undefined) kept.texts = before;
    return reply?.sessionList !== undefined;
  }

  async #delete(name: string): Promise<boolean> {
    const kept = this.#ledger.sessions.get(name)!;
    kept.isThere = undefined;
    const reply = await this.#tryAsk({
      topic: '/services/session/database/delete',
      session: { name },
    });
    if (reply !== undefined) kept.isThere = reply.success === undefined;
    return reply?.success !== undefined;
  }

  async #grant(): Promise<boolean> {
    const reply = await this.#tryAsk({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: {
        role: AccessRole.ACCESS_ROLE_PLAYER,
        label: `leave ${++this.#count}`,
        lifetimeMs: 7 * 24 * 3_600_000,
      },
    });
    const created = reply?.accessGrantCreated;
    if (created === undefined) return false;
    const { id } = created.grant!;
    this.#ledger.grants.set(id, { id, token: created.token, isGood: true });
    return true;
  }

  async #revoke(id: string): Promise<boolean> {
    const kept = this.#ledger.grants.get(id)!;
    kept.isGood = undefined;
    const reply = await this.#tryAsk({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: { grantId: id },
    });
    if (reply !== undefined) kept.isGood = reply.error !== undefined;
    return reply !== undefined && reply.error === undefined;
  }

  async #start(): Promise<boolean> {
    const name = `kept ${++this.#count}`;
    const reply = await this.#tryAsk({
      topic: '/services/session/runtime/start',
      session: { ...ticking(name, `/${name}`), extension: { startWithMaster: true } },
    });
    if (reply?.session === undefined) return false;
    this.#ledger.running.add(reply.session.id);
    return true;
  }

  async #tryAsk(request: Parameters<Ask>[0]): Promise<Awaited<ReturnType<Ask>> | undefined> {
    try {
      const reply = await this.#ask(request);
      if (reply.error !== undefined) this.lastRefusal = reply.error.message;
      return reply;
    } catch (error) {
      this.lastRefusal = String(error);
      return undefined;
    }
  }
}
