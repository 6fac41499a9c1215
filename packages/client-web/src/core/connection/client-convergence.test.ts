import { describe, expect, it } from 'vitest';
import { createTestClient } from '../../testing/create-test-client.ts';
import { FakeMaster } from '../../testing/fake-master.ts';
import type { RegisteredDevice } from '../devices/devices.ts';
import type { Subscription, UbiiClient } from '../../index.ts';

const SEEDS = Array.from({ length: 60 }, (_, i) => i + 1);
const STEPS = 60;

/** Park-Miller: the same story for the same seed. */
function createRandom(seed: number): () => number {
  let state = seed * 16_807;
  return () => (state = (state * 48_271) % 2_147_483_647) / 2_147_483_647;
}

/** Random actions of a program and events of its environment. */
class Story {
  readonly master: FakeMaster;
  readonly random: () => number;
  readonly subscriptions = new Set<{ topic: string; subscription: Subscription }>();
  readonly devices = new Map<string, RegisteredDevice>();
  readonly #test: ReturnType<typeof createTestClient>;
  #names = 0;

  constructor(seed: number, isOriginal: boolean) {
    this.random = createRandom(seed);
    this.master = new FakeMaster({ isOriginal });
    this.#test = createTestClient(this.master, { random: this.random });
  }

  get client(): UbiiClient {
    return this.#test.client;
  }

  pass(ms: number): Promise<void> {
    return this.#test.clock.advance(ms);
  }

  get timerCount(): number {
    return this.#test.clock.timerCount;
  }

  async step(): Promise<void> {
    this.#pick([
      () => this.#subscribe(),
      () => this.#subscribe(),
      () => this.#unsubscribe(),
      () => this.#register(),
      () => this.#closeDevice(),
      () => this.client.publish(`/p${this.#below(5)}`, 'double', this.#below(100)),
      () => this.master.drop(this.#pick([1001, 1006, 4008, 4009, 1000])),
      () => this.master.restart({ hasNewKey: this.random() < 0.2 }),
      () => this.master.stop(),
      () => (this.master.isDown = false),
      () => (this.master.isSilent = this.random() < 0.5),
      () => this.client.retryNow(),
      () => void this.client.rename(`name ${this.#names++}`).catch(() => undefined),
      () => void this.client.call('topicList').catch(() => undefined),
    ])();
    const turns = this.#below(12);
    for (let i = 0; i < turns; i++) await Promise.resolve();
    if (this.random() < 0.6) await this.pass(this.#below(4_000));
  }

  #subscribe(): void {
    const topic = `/t${this.#below(6)}`;
    const subscription = this.client.subscribe(topic);
    subscription.ready.catch(() => undefined);
    this.subscriptions.add({ topic, subscription });
  }

  #unsubscribe(): void {
    const [entry] = this.subscriptions;
    if (entry === undefined) return;
    this.subscriptions.delete(entry);
    void entry.subscription.close();
  }

  #register(): void {
    const name = `device ${this.#names++}`;
    void this.client
      .registerDevice({ name, components: [{ name: 'c', format: 'double' }] })
      .then((device) => this.devices.set(name, device));
  }

  #closeDevice(): void {
    const [name] = this.devices.keys();
    if (name === undefined) return;
    void this.devices.get(name)?.close();
    this.devices.delete(name);
  }

  #pick<T>(all: readonly T[]): T {
    return all[this.#below(all.length)]!;
  }

  #below(limit: number): number {
    return Math.floor(this.random() * limit);
  }
}

describe.each([
  ['a master of ours', false],
  ['an original master', true],
])('a client of %s, whatever happens', (_, isOriginal) => {
  it.each(SEEDS)('has in the end what it wants, and no more (story %i)', async (seed) => {
    const story = new Story(seed, isOriginal);
    const { master, client } = story;
    void client.connect();
    for (let i = 0; i < STEPS; i++) await story.step();

    master.isDown = false;
    master.isSilent = false;
    await story.pass(60_000);
    expect(client.state.status).toBe('connected');
    const held = master.holds(client.id);
    expect(held.topics).toEqual(
      [...new Set([...story.subscriptions].map(({ topic }) => topic))].sort(),
    );
    const deviceNames = held.devices.map(({ name }) => name).sort();
    if (isOriginal) {
      // After a lost reply, the master may have a device that the client does not know.
      expect(deviceNames).toEqual(expect.arrayContaining([...story.devices.keys()]));
    } else {
      expect(deviceNames).toEqual([...story.devices.keys()].sort());
      expect(held.name).toBe(client.name);
    }

    // And it works: what is published arrives.
    const values: unknown[] = [];
    client.subscribe('/end').onRecord(({ value }) => values.push(value));
    await story.pass(100);
    client.publish('/end', 'double', seed);
    await story.pass(100);
    expect(values).toEqual([seed]);

    const closed = client.close();
    await story.pass(10_000);
    await closed;
    expect(master.clientIds).not.toContain(client.id);
    expect(story.timerCount).toBe(0);
  });
});
