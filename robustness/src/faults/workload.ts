import { AccessRole } from '@ubii/proto';

import { periodicSession } from '../fixtures/sessions.ts';
import type { Random } from '../random.ts';
import type { Ask, ExpectedState } from './expected-state.ts';

const MAX_SESSIONS = 40;
const MAX_GRANTS = 40;
const MAX_RUNNING = 3;

/** Changes that an operator makes over an hour. Records the acknowledged ones in the expected state. */
export class Workload {
  readonly #random: Random;
  readonly #expected: ExpectedState;
  readonly #ask: Ask;
  /** Characters of the descriptions of sessions: how quickly a disk is full. */
  readonly #textLength: number;
  #count = 0;
  acknowledged = 0;
  refused = 0;
  /** Reason why the master did not acknowledge the last refused request. */
  lastRefusal = '';

  constructor(random: Random, expected: ExpectedState, ask: Ask, textLength = 200) {
    this.#random = random;
    this.#expected = expected;
    this.#ask = ask;
    this.#textLength = textLength;
  }

  /** Makes one change. @returns false when the master refused it or gave no answer */
  step(): Promise<boolean> {
    return this.#record(this.#choose());
  }

  /** Stores one more session, whatever there is. @returns as above */
  save(): Promise<boolean> {
    return this.#record(this.#save());
  }

  async #record(doing: Promise<boolean>): Promise<boolean> {
    const isDone = await doing;
    if (isDone) this.acknowledged++;
    else this.refused++;
    return isDone;
  }

  #choose(): Promise<boolean> {
    const { sessions, grants, running } = this.#expected;
    const stored = [...sessions.values()].filter(({ isStored }) => isStored === true);
    const good = [...grants.values()].filter(({ isValid }) => isValid === true);
    if (running.size < MAX_RUNNING && this.#random.oneIn(4)) return this.#start();
    switch (this.#random.below(6)) {
      case 0:
      case 1:
        return good.length < MAX_GRANTS ? this.#grant() : this.#revoke(this.#random.pick(good).id);
      case 2:
        return good.length > 4 ? this.#revoke(this.#random.pick(good).id) : this.#grant();
      case 3:
        if (stored.length > 4) return this.#change(this.#random.pick(stored).name);
        return this.#save();
      case 4:
        if (stored.length > 8) return this.#delete(this.#random.pick(stored).name);
        return this.#save();
      default:
        return stored.length < MAX_SESSIONS
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
      session: { ...periodicSession(name, `/${name}`), description },
    });
    if (reply?.sessionList === undefined) return false;
    this.#expected.sessions.set(name, { name, texts: [description], isStored: true });
    return true;
  }

  async #change(name: string): Promise<boolean> {
    const kept = this.#expected.sessions.get(name)!;
    this.#count++;
    const description = this.#text();
    const before = kept.texts;
    kept.texts = [...before, description];
    const reply = await this.#tryAsk({
      topic: '/services/session/database/save',
      session: { ...periodicSession(name, `/${name}`), description },
    });
    if (reply?.sessionList !== undefined) kept.texts = [description];
    // Refused by the master itself: what was there stands. Without an answer it may be either.
    else if (reply !== undefined) kept.texts = before;
    return reply?.sessionList !== undefined;
  }

  async #delete(name: string): Promise<boolean> {
    const kept = this.#expected.sessions.get(name)!;
    kept.isStored = undefined;
    const reply = await this.#tryAsk({
      topic: '/services/session/database/delete',
      session: { name },
    });
    if (reply !== undefined) kept.isStored = reply.success === undefined;
    return reply?.success !== undefined;
  }

  async #grant(): Promise<boolean> {
    const reply = await this.#tryAsk({
      topic: '/services/ubii/access_grant_create',
      accessGrantCreateRequest: {
        role: AccessRole.ACCESS_ROLE_PLAYER,
        label: `invitation ${++this.#count}`,
        lifetimeMs: 7 * 24 * 3_600_000,
      },
    });
    const created = reply?.accessGrantCreated;
    if (created === undefined) return false;
    const { id } = created.grant!;
    this.#expected.grants.set(id, { id, token: created.token, isValid: true });
    return true;
  }

  async #revoke(id: string): Promise<boolean> {
    const kept = this.#expected.grants.get(id)!;
    kept.isValid = undefined;
    const reply = await this.#tryAsk({
      topic: '/services/ubii/access_grant_revoke',
      accessGrantRevokeRequest: { grantId: id },
    });
    if (reply !== undefined) kept.isValid = reply.error !== undefined;
    return reply !== undefined && reply.error === undefined;
  }

  async #start(): Promise<boolean> {
    const name = `kept ${++this.#count}`;
    const reply = await this.#tryAsk({
      topic: '/services/session/runtime/start',
      session: { ...periodicSession(name, `/${name}`), extension: { startWithMaster: true } },
    });
    if (reply?.session === undefined) return false;
    this.#expected.running.add(reply.session.id);
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
