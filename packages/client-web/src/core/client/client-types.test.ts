import type { DataFormat, TopicRecord, Vector2 } from '@ubii/proto';
import { describe, expectTypeOf, it } from 'vitest';
import type { RegisteredComponent } from '../devices/devices.ts';
import type { Subscription } from '../subscriptions/subscription.ts';
import type { UbiiClient } from './ubii-client.ts';

// Checked by tsc; nothing of it runs.
const check = (_: (client: UbiiClient) => unknown): void => undefined;

describe('the types of the client', () => {
  it('let a value be published only with its format', () => {
    check((client) => {
      client.publish('/a', 'vector2', { x: 1, y: 2 });
      client.publish('/a', 'bool', true);
      client.publish('/a', 'stringList', { elements: ['x'] });
      // @ts-expect-error a member is missing
      client.publish('/a', 'vector2', { x: 1 });
      // @ts-expect-error a member too many
      client.publish('/a', 'vector2', { x: 1, y: 2, z: 3 });
      // @ts-expect-error wrong type of a member
      client.publish('/a', 'vector2', { x: '1', y: 2 });
      // @ts-expect-error wrong value
      client.publish('/a', 'double', '1');
      // @ts-expect-error no such format
      client.publish('/a', 'vector5', { x: 1, y: 2 });
    });
  });

  it('narrow a record by its format', () => {
    check((client) => {
      const any = client.subscribe('/a');
      expectTypeOf(any).toEqualTypeOf<Subscription<DataFormat>>();
      any.onRecord((record) => {
        if (record.format === 'vector2') expectTypeOf(record.value).toEqualTypeOf<Vector2>();
        if (record.format === 'double') expectTypeOf(record.value).toEqualTypeOf<number>();
        // @ts-expect-error not every value has an x
        return record.value.x;
      });
      const vectors = client.subscribe({ glob: '/*' }, { format: 'vector2', maxRateHz: 5 });
      expectTypeOf(vectors).toEqualTypeOf<Subscription<'vector2'>>();
      vectors.onRecord((record) => expectTypeOf(record).toEqualTypeOf<TopicRecord<'vector2'>>());
      expectTypeOf(client.subscribe('/a', { maxRateHz: 5 })).toEqualTypeOf<Subscription>();
      return async () => {
        for await (const { value } of vectors) expectTypeOf(value).toEqualTypeOf<Vector2>();
      };
    });
  });

  it('take one kind of pattern at a time', () => {
    check((client) => {
      client.subscribe({ component: { tags: ['touch'], format: 'vector2' } });
      client.subscribe({ regex: /a/ });
      // @ts-expect-error no such kind
      client.subscribe({ wildcard: '/*' });
      // @ts-expect-error not a data format
      client.subscribe('/a', { format: 'vector5' });
    });
  });

  it('ask each service for its request and promise its reply', () => {
    check(async (client) => {
      expectTypeOf((await client.call('topicList')).elements).toEqualTypeOf<string[]>();
      const { elements } = await client.call('clientGetList', { elements: [{ name: 'ada' }] });
      expectTypeOf(elements[0]!.name).toEqualTypeOf<string>();
      await client.call('clientGetList');
      await client.call('topicStatistics', { cursor: 0 });
      // @ts-expect-error it needs a request
      await client.call('topicStatistics');
      // @ts-expect-error it takes none
      await client.call('topicList', { elements: [] });
      // @ts-expect-error the request of another service
      await client.call('topicStatistics', { name: 'ada' });
      // @ts-expect-error no such service
      await client.call('topicLists');
    });
  });

  it('know the components of a device by name', () => {
    check(async (client) => {
      const device = await client.registerDevice({
        name: 'phone',
        components: [
          { name: 'touch', format: 'vector2' },
          { name: 'pressed', format: 'bool', ioType: 'publisher' },
        ],
      });
      expectTypeOf(device.component('touch')).toEqualTypeOf<RegisteredComponent<'vector2'>>();
      device.component('pressed').publish(true);
      // @ts-expect-error the value of another component
      device.component('touch').publish(true);
      // @ts-expect-error no such component
      device.component('wheel');
      await client.registerDevice({
        name: 'phone',
        // @ts-expect-error no such format
        components: [{ name: 'touch', format: 'vector5' }],
      });
    });
  });

  it('tell what each state carries', () => {
    check(({ state }) => {
      if (state.status === 'reconnecting')
        expectTypeOf(state.nextAttemptMs).toEqualTypeOf<number>();
      // @ts-expect-error only when connected
      return state.clientId as string;
    });
  });
});
