import { describe, expect, it } from 'vitest';
import { Re2Patterns } from '@ubii/patterns/re2';
import { FakeClock } from '@ubii/timing/testing';
import { TestMaster, type TestMasterOptions } from '../src/testing/index.ts';
import { TRUSTED_CALLER } from '../src/index.ts';

async function createPair(options: TestMasterOptions = {}) {
  const master = new TestMaster(options);
  const ada = await master.legacy('ada');
  const ben = await master.legacy('ben');
  return { master, ada, ben };
}

describe('subscriptions', () => {
  it('belong to the client, not to its socket [TD-20]', async () => {
    const { ada, ben } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/b'] });
    ben.drop();
    ben.open();
    ada.publish('/a', 'double', 1);
    ada.publish('/b/c', 'double', 2);
    expect(ben.takeValues()).toEqual([
      ['/a', 1],
      ['/b/c', 2],
    ]);
  });

  it('by regular expression match anywhere, and case counts [TD-20]', async () => {
    const { ada, ben } = await createPair();
    await ben.subscribe({ subscribeTopicRegexp: ['b/c'] });
    for (const topic of ['/a/b/c/d', 'b/c', '/a/B/c', '/a/b']) ada.publish(topic, 'bool', true);
    expect(ben.takeValues().map(([topic]) => topic)).toEqual(['/a/b/c/d', 'b/c']);
  });

  it.each(['(', '(?=a)', '(a)\\1', '(?<!x)y', 'a**'])(
    'by the regular expression %s are refused, with the reason [TD-21]',
    async (source) => {
      const { ben, ada } = await createPair({ patterns: new Re2Patterns() });
      await expect(ben.subscribe({ subscribeTopicRegexp: [source] })).rejects.toThrow(
        /^invalid_argument: ".*" is not a regular expression in RE2 syntax: .+/,
      );
      ada.publish('/a', 'double', 1);
      expect(ben.takeSent()).toEqual([]);
    },
  );

  it('are matched when topics and subscriptions appear, not when data flows [TD-22]', async () => {
    let tests = 0;
    const patterns = {
      compile: (source: string) => ({
        test: (text: string) => {
          tests++;
          return new RegExp(source).test(text);
        },
        match: () => undefined,
      }),
    };
    const { ada, ben } = await createPair({ patterns });
    ada.publish('/a', 'double', 1);
    await ben.subscribe({ subscribeTopicRegexp: ['[ab]$'] });
    const afterSubscription = tests;
    expect(afterSubscription).toBeGreaterThan(0);
    ada.publish('/b', 'double', 1);
    expect(tests).toBe(afterSubscription + 1);
    for (let i = 0; i < 100; i++) {
      ada.publish('/a', 'double', i);
      ada.publish('/b', 'double', i);
    }
    expect(tests).toBe(afterSubscription + 1);
    expect(ben.takeValues()).toHaveLength(201);
  });

  it('made twice are one, and are ended by one [TD-23]', async () => {
    const { ada, ben } = await createPair();
    for (let i = 0; i < 2; i++) {
      await ben.subscribe({ subscribeTopics: ['/a', '/a'], subscribeTopicRegexp: ['^/b', '^/b'] });
    }
    ada.publish('/a', 'double', 1);
    ada.publish('/b', 'double', 2);
    expect(ben.takeValues()).toHaveLength(2);
    await ben.subscribe({ unsubscribeTopics: ['/a'], unsubscribeTopicRegexp: ['^/b'] });
    ada.publish('/a', 'double', 3);
    ada.publish('/b', 'double', 4);
    expect(ben.takeValues()).toEqual([]);
  });

  it('that are not there are ended with success [TD-23]', async () => {
    const { ben } = await createPair();
    for (let i = 0; i < 2; i++) {
      await ben.subscribe({
        unsubscribeTopics: ['/a', ''],
        unsubscribeTopicRegexp: ['^/b', '('],
        unsubscribeComponents: [{ name: 'pointer' }],
      });
    }
  });

  it('send the retained record after the reply, to legacy clients a moment later [TD-24] [EC-9]', async () => {
    const { master, ada, ben } = await createPair();
    const cleo = await master.extension('cleo');
    ada.publish('/a', 'double', 1);
    for (const client of [ben, cleo]) {
      const { reply, afterReply } = await master.master.handleServiceRequest(
        requestOf(client.id, { subscribeTopics: ['/a'] }),
        TRUSTED_CALLER,
      );
      master.clock.advanceSync(100);
      expect(reply.success).toBeDefined();
      expect(client.takeSent()).toEqual([]);
      afterReply();
      master.clock.endTurnSync();
      if (client === ben) {
        expect(client.takeSent()).toEqual([]);
        master.clock.advanceSync(24);
        expect(client.takeSent()).toEqual([]);
        master.clock.advanceSync(1);
      }
      expect(client.takeValues()).toEqual([['/a', 1]]);
      afterReply();
      master.clock.advanceSync(100);
      expect(client.takeValues()).toEqual([]);
    }
  });

  it('do not send the retained record after a newer one [TD-14] [TD-24]', async () => {
    const { master, ada, ben } = await createPair();
    ada.publish('/a', 'double', 1);
    const { afterReply } = await master.master.handleServiceRequest(
      requestOf(ben.id, { subscribeTopics: ['/a'] }),
      TRUSTED_CALLER,
    );
    ada.publish('/a', 'double', 2);
    afterReply();
    master.clock.advanceSync(100);
    expect(ben.takeValues()).toEqual([['/a', 2]]);
  });

  it('send no retained record when they were ended in the meantime [TD-24]', async () => {
    const { master, ada, ben } = await createPair();
    ada.publish('/a', 'double', 1);
    for (const list of ['subscribeTopics', 'unsubscribeTopics']) {
      await ben.call({
        topic: '/services/topic_subscription',
        topicSubscription: { clientId: ben.id, [list]: ['/a'] },
      });
    }
    master.clock.advanceSync(100);
    expect(ben.takeSent()).toEqual([]);
  });

  it('send the retained record once the socket is open [TD-24] [EC-8]', async () => {
    const { master, ada } = await createPair();
    ada.publish('/a', 'double', 1);
    ada.publish('/b', 'double', 2);
    const cleo = await master.register({ name: 'cleo' });
    await cleo.subscribe({ subscribeTopics: ['/a', '/b'] });
    await cleo.subscribe({ unsubscribeTopics: ['/b'] });
    ada.publish('/a', 'double', 3);
    cleo.open();
    expect(cleo.takeValues()).toEqual([['/a', 3]]);
    cleo.drop();
    cleo.open();
    expect(cleo.takeValues()).toEqual([]);
  });

  it('by pattern and profile send retained records to extension clients only [TD-24] [EC-9]', async () => {
    const { master, ada, ben } = await createPair();
    await ada.call({
      topic: '/services/device/registration',
      device: { clientId: ada.id, components: [{ topic: '/c', tags: ['pen'] }] },
    });
    ada.publish('/a', 'double', 1);
    ada.publish('/c', 'double', 2);
    const cleo = await master.extension('cleo');
    for (const client of [ben, cleo]) {
      await client.subscribe({
        subscribeTopicRegexp: ['^/a'],
        subscribeComponents: [{ tags: ['pen'] }],
      });
    }
    expect(ben.takeValues()).toEqual([]);
    expect(cleo.takeValues()).toEqual([
      ['/a', 1],
      ['/c', 2],
    ]);
  });

  it('outlive the value of their topic [TD-25]', async () => {
    const { master, ada, ben } = await createPair();
    await ben.subscribe({ subscribeTopics: ['/a'], subscribeTopicRegexp: ['^/b'] });
    ada.publish('/a', 'double', 1);
    ada.publish('/b', 'double', 2);
    await ada.call({ topic: '/services/client/deregistration', client: { id: ada.id } });
    ben.takeSent();
    const cleo = await master.legacy('cleo');
    cleo.publish('/a', 'double', 3);
    cleo.publish('/b', 'double', 4);
    expect(ben.takeValues()).toEqual([
      ['/a', 3],
      ['/b', 4],
    ]);
    // And they can be ended as ever.
    await ben.subscribe({ unsubscribeTopics: ['/a'], unsubscribeTopicRegexp: ['^/b'] });
    cleo.publish('/a', 'double', 5);
    cleo.publish('/b', 'double', 6);
    expect(ben.takeValues()).toEqual([]);
  });

  it('to topics under /ubii/ are served for extension clients only [TD-26]', async () => {
    const { master, ben } = await createPair();
    const cleo = await master.extension('cleo');
    const topic = `/ubii/client/${ben.id}`;
    for (const client of [ben, cleo]) {
      await client.subscribe({
        subscribeTopics: [topic],
        subscribeTopicRegexp: ['.*', 'client', '^/ubii/', '/ubii/'],
      });
    }
    expect(ben.takeSent()).toEqual([]);
    expect(cleo.takeRecords().map((record) => record.topic)).toContain(topic);
    await ben.call({
      topic: '/services/device/registration',
      device: { clientId: ben.id, name: 'pen' },
    });
    expect(ben.takeRecords().map((record) => record.topic)).not.toContain(topic);
    expect(cleo.takeRecords().filter((record) => record.topic === topic)).toHaveLength(1);
  });

  it.each([
    ['^/ubii/client/', true],
    ['/ubii/', true],
    ['.*', false],
    ['client', false],
    ['^/(ubii|x)/', false],
    ['ubii/', false],
  ])('by the regular expression %s reach topics under /ubii/: %s [TD-26]', async (source, do_) => {
    const { master } = await createPair();
    const cleo = await master.extension('cleo');
    await cleo.subscribe({ subscribeTopicRegexp: [source] });
    expect(cleo.takeRecords().some(({ topic }) => topic.startsWith('/ubii/'))).toBe(do_);
  });

  it('by component profile reach the publishers that match, later ones too [TD-27]', async () => {
    const { ada, ben } = await createPair();
    const register = (name: string, tags: string[], ioType: 0 | 1 = 0) =>
      ada.call({
        topic: '/services/device/registration',
        device: { clientId: ada.id, components: [{ topic: `/${name}`, name, tags, ioType }] },
      });
    await register('early', ['pen']);
    await ben.subscribe({ subscribeComponents: [{ tags: ['pen'] }] });
    await register('late', ['pen', 'red']);
    await register('other', ['brush']);
    await register('listener', ['pen'], 1);
    const publishAll = () => {
      for (const name of ['early', 'late', 'other', 'listener']) {
        ada.publish(`/${name}`, 'bool', true);
      }
    };
    publishAll();
    expect(ben.takeValues().map(([topic]) => topic)).toEqual(['/early', '/late']);
    // The same profile, however it is written, is the same subscription.
    await ben.subscribe({ unsubscribeComponents: [{ tags: ['pen'], name: '' }] });
    publishAll();
    expect(ben.takeValues()).toEqual([]);
  });

  it('by component profile end with the last component that matches [TD-27]', async () => {
    const { ada, ben } = await createPair();
    const devices = [];
    for (let i = 0; i < 2; i++) {
      const { device } = await ada.call({
        topic: '/services/device/registration',
        device: { clientId: ada.id, components: [{ topic: '/pen', tags: ['pen'] }] },
      });
      devices.push(device!);
    }
    await ben.subscribe({ subscribeComponents: [{ tags: ['pen'] }] });
    const seen = [];
    for (const device of devices) {
      ada.publish('/pen', 'bool', true);
      seen.push(ben.takeValues().length);
      await ada.call({ topic: '/services/device/deregistration', device });
    }
    ada.publish('/pen', 'bool', true);
    seen.push(ben.takeValues().length);
    expect(seen).toEqual([1, 1, 0]);
  });

  it('that take long to match are refused [TD-29]', async () => {
    const clock = new FakeClock();
    const { ada, ben } = await createPair({ clock, patterns: slowPatterns(clock) });
    for (let i = 0; i < 40; i++) ada.publish(`/a/${i}`, 'bool', true);
    await ben.subscribe({ subscribeTopicRegexp: ['(fast)'] });
    await expect(ben.subscribe({ subscribeTopicRegexp: ['(slow)'] })).rejects.toThrow(
      /^resource_exhausted: .*patternMatchMs/,
    );
    await expect(ben.subscribe({ subscribeTopicRegexp: ['(other)'] })).rejects.toThrow(
      'patternMatchMs',
    );
    // Existing subscriptions continue, and the budget recovers with time.
    ada.publish('/fast', 'bool', true);
    expect(ben.takeValues()).toHaveLength(1);
    clock.advanceSync(4_000);
    await ben.subscribe({ subscribeTopicRegexp: ['(other)'] });
  });

  it('are not ended because the machine stood still while a topic was matched [TD-29]', async () => {
    const clock = new FakeClock();
    const { ada, ben } = await createPair({ clock, patterns: slowPatterns(clock) });
    await ben.subscribe({ subscribeTopicRegexp: ['(stalled)'] });
    ada.publish('/stalled', 'bool', true);
    expect(ben.takeValues()).toEqual([['/stalled', true]]);
    expect(ben.takeErrors()).toEqual([]);
  });

  it('that make new topics slow are ended, and the client is told [TD-29]', async () => {
    const clock = new FakeClock();
    const { master, ada, ben } = await createPair({ clock, patterns: slowPatterns(clock) });
    const cleo = await master.legacy('cleo');
    await cleo.subscribe({ subscribeTopicRegexp: ['(fast)'] });
    await ben.subscribe({ subscribeTopics: ['/slow'], subscribeTopicRegexp: ['(slow)', '(fast)'] });
    const startMs = clock.monotonicMs();
    for (let i = 0; i < 1000; i++) ada.publish(`/slow/${i}`, 'bool', true);
    // Twenty milliseconds each, until half a second was spent.
    expect(clock.monotonicMs() - startMs).toBeLessThan(600);
    const errors = ben.takeErrors();
    expect(errors).toMatchObject([{ code: 'resource_exhausted' }]);
    expect(errors[0]?.message).toContain('patternMatchMs');
    ada.publish('/fast', 'bool', true);
    ada.publish('/slow', 'bool', true);
    expect(cleo.takeValues()).toEqual([['/fast', true]]);
    expect(ben.takeValues()).toEqual([['/slow', true]]);
  });
});

/**
 * Patterns that find their text anywhere; `(slow)` takes 20 ms for a topic, during
 * `(stalled)` something else has the machine. In parentheses, because
 * the master looks for plain text itself.
 */
function slowPatterns(clock: FakeClock) {
  return {
    compile: (source: string) => ({
      test: (text: string) => {
        if (source === '(slow)') clock.spend(20);
        if (source === '(stalled)') clock.spend(5_000);
        return text.includes(source.slice(1, -1));
      },
      match: () => undefined,
    }),
  };
}

function requestOf(clientId: string, subscription: { subscribeTopics: string[] }) {
  return {
    topic: '/services/topic_subscription',
    topicSubscription: {
      clientId,
      subscribeTopics: subscription.subscribeTopics,
      unsubscribeTopics: [],
      subscribeTopicRegexp: [],
      unsubscribeTopicRegexp: [],
      subscribeComponents: [],
      unsubscribeComponents: [],
      maxRateHz: 0,
    },
  };
}
