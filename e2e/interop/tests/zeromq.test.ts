import { SessionStatus } from '@ubii/proto';
import { describe, expect, test } from 'vitest';
import { LegacyClient } from '../harness/legacy-client.ts';
import { suiteName, useRoom, whereClientsLook, whyMissing } from '../harness/room.ts';
import { endMaster, startMaster } from '../../fixtures/start-master.ts';

const room = useRoom();

/** A client that answers is pinged about every 3 s: three pings take longer than the 5 s of CL-13. */
const PINGS = 3;
/** Interval at which a value is published again until a node runs, milliseconds. */
const PUBLISH_AGAIN_MS = 200;

describe.skipIf(whyMissing('nodejs'))(`${suiteName('nodejs')} over ZeroMQ`, () => {
  test('exchanges records by topic and by regular expression, until it unsubscribes [TD-50]', async () => {
    const guest = await room.joinsOverZeroMq('a guest of old');
    const ours = await room.oursJoins();
    const subscription = ours.subscribe({ glob: '/from/guest/**' });
    await subscription.ready;
    const got: unknown[] = [];
    subscription.onRecord((record) => got.push([record.topic, record.value]));
    await guest.subscribeTopic('/to/guest');
    await guest.subscribeRegex('/pattern/*');
    await guest.isGiven('/to/guest', { x: 1, y: 0 }, () =>
      ours.publish('/to/guest', 'vector2', { x: 1, y: 0 }),
    );
    await guest.isGiven('/pattern/one', 2, () => ours.publish('/pattern/one', 'double', 2));
    await guest.publish([{ topic: '/from/guest/a', double: 1 }], { immediately: true });
    await expect.poll(() => got).toHaveLength(1);
    await guest.publish([
      { topic: '/from/guest/b', string: 'two' },
      { topic: '/from/guest/a', double: 3 },
    ]);
    await expect
      .poll(() => got)
      .toEqual([
        ['/from/guest/a', 1],
        ['/from/guest/b', 'two'],
        ['/from/guest/a', 3],
      ]);

    await guest.unsubscribe('/to/guest');
    ours.publish('/to/guest', 'string', 'no subscriber');
    await guest.isGiven('/pattern/two', 4, () => ours.publish('/pattern/two', 'double', 4));
    const values = guest.events.all.flatMap((event) =>
      event.event === 'record' ? [event.value] : [],
    );
    expect(values).not.toContain('no subscriber');
    expect([guest.frames('list'), guest.frames('error'), guest.frames('empty')]).toEqual([0, 0, 0]);
    expect(guest.complaints).toEqual([]);
  });

  test('registers a device, answers pings, and is gone when it deregisters [CL-12] [CL-16]', async () => {
    const guest = await room.joinsOverZeroMq();
    const ours = await room.oursJoins();
    const device = await guest.registerDevice({
      name: 'lamp',
      components: [{ topic: '/lamp/light', messageFormat: 'bool', ioType: 0 }],
    });
    expect(device).toMatchObject({ name: 'lamp', clientId: guest.clientId });
    await guest.isPinged(PINGS);
    const listed = await room.listed(ours, guest.clientId);
    expect(listed).toMatchObject({ state: 0 });
    expect(listed?.latency).toBeGreaterThan(0);
    await guest.callService({
      topic: '/services/client/deregistration',
      client: { id: guest.clientId },
    });
    expect(await room.listed(ours, guest.clientId)).toBeUndefined();
    const devices = await ours.call('deviceGetList', { elements: [{ clientId: guest.clientId }] });
    expect(devices.elements).toEqual([]);
    expect(guest.complaints).toEqual([]);
  });

  test('runs a module of a session, until the session stops [SE-12] [SE-13]', async () => {
    const guest = await room.joinsOverZeroMq();
    const ours = await room.oursJoins();
    const got: unknown[] = [];
    const subscription = ours.subscribe('/out');
    await subscription.ready;
    subscription.onRecord(({ value }) => got.push(value));
    const { id } = await ours.call('sessionRuntimeStart', {
      name: 'over ZeroMQ',
      processingModules: [
        {
          name: 'js-double',
          nodeId: guest.clientId,
          processingMode: { triggerOnInput: { minDelayMs: 0, allInputsNeedUpdate: false } },
          inputs: [{ internalName: 'value', messageFormat: 'double' }],
          outputs: [{ internalName: 'twice', messageFormat: 'double' }],
          onProcessingStringified:
            '(deltaTime, inputs, state) => inputs.value ? { outputs: { twice: { double: inputs.value.double * 2 } }, state } : { outputs: {}, state }',
        },
      ],
      ioMappings: [
        {
          processingModuleName: 'js-double',
          inputMappings: [{ inputName: 'value', topic: '/in' }],
          outputMappings: [{ outputName: 'twice', topic: '/out' }],
        },
      ],
    });
    const statusIs = (status: SessionStatus) =>
      expect.poll(async () => (await ours.call('sessionRuntimeGet', { id })).status).toBe(status);
    await statusIs(SessionStatus.RUNNING);
    const again = setInterval(() => ours.publish('/in', 'double', 21), PUBLISH_AGAIN_MS);
    await expect
      .poll(() => got.at(-1))
      .toBe(42)
      .finally(() => clearInterval(again));
    await ours.call('sessionRuntimeStop', { id });
    await statusIs(SessionStatus.STOPPED);
    expect(guest.complaints).toEqual([]);
  });

  test('is no client where callers of its place have not been admitted [AC-5]', async () => {
    const master = await startMaster({
      trustsLoopback: false,
      flags: ['--zeromq-ports', '0,0', '--loopback', 'none'],
    });
    const guest = await LegacyClient.start('nodejs');
    try {
      const { zeromq } = await whereClientsLook(master);
      const connected = await guest.connect(zeromq, 'stranger');
      expect(connected).toMatchObject({
        server: { portServiceZmq: zeromq.services.split(':')[2] },
      });
      expect(connected.clientId).toBeUndefined();
      expect(master.failures).toEqual([]);
    } finally {
      await guest.stop();
      await endMaster(master);
    }
  });
});
