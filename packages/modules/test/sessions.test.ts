import type { Init, Session } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { EXAMPLE_SESSIONS } from '../src/index.ts';
import { PLAIN_MODULES } from './plain-modules.ts';
import { startSession } from './session-world.ts';

const ANN = '0f8fad5b-d9cb-469f-a165-70867728950e';
const BOB = '7c9e6679-7425-40de-944b-e07fc1f90ae7';

/** One module with its ends on topics of their names. */
function sessionOf(name: string, inputs: string[], outputs: string[]): Init<Session> {
  return {
    name: 'test',
    processingModules: [{ name }],
    ioMappings: [
      {
        processingModuleName: name,
        inputMappings: inputs.map((inputName) => ({ inputName, topic: `/${inputName}` })),
        outputMappings: outputs.map((outputName) => ({ outputName, topic: `/${outputName}` })),
      },
    ],
  };
}

describe('the session mirror-pointer', () => {
  it('answers every position, and follows its switches', async () => {
    const topic = '/examples/mirror-pointer';
    const { clock, topics, values, events } = await startSession(
      EXAMPLE_SESSIONS['mirror-pointer'],
    );
    topics.put(`${topic}/pointer`, 'vector2', { x: 0.25, y: 0 });
    await clock.endTurn();
    topics.put(`${topic}/mirror_x`, 'bool', true);
    await clock.endTurn();
    topics.put(`${topic}/mirror_y`, 'bool', true);
    topics.put(`${topic}/mirror_x`, 'bool', false);
    await clock.endTurn();
    expect(values(`${topic}/mirrored`)).toEqual([
      { x: 0.25, y: 0 },
      { x: 0.75, y: 0 },
      { x: 0.25, y: 1 },
    ]);
    expect(events).toEqual([]);
  });
});

describe('the session smooth-pointer', () => {
  it('follows a pointer calmly, and arrives where it rests', async () => {
    const topic = '/examples/smooth-pointer';
    const { clock, topics, values, events } = await startSession(
      EXAMPLE_SESSIONS['smooth-pointer'],
    );
    const smoothed = () => (values(`${topic}/smoothed`) as { x: number; y: number }[]).at(-1);
    topics.put(`${topic}/pointer`, 'vector2', { x: 0, y: 0.5 });
    await clock.advance(20);
    expect(smoothed()).toEqual({ x: 0, y: 0.5 });
    topics.put(`${topic}/pointer`, 'vector2', { x: 1, y: 0.5 });
    await clock.advance(20);
    expect(smoothed()!.x).toBeGreaterThan(0);
    expect(smoothed()!.x).toBeLessThan(1);
    await clock.advance(5000);
    expect(smoothed()!.x).toBeCloseTo(1, 3);
    expect(events).toEqual([]);
  });
});

describe('the session gather-pointers', () => {
  it('counts those that are near one another, mice and fingers alike', async () => {
    const { clock, topics, values, events } = await startSession(
      EXAMPLE_SESSIONS['gather-pointers'],
    );
    const pointer = 'web-example-mouse-pointer/mouse_client_position';
    topics.put(`/${ANN}/${pointer}`, 'vector2', { x: 0.5, y: 0.5 });
    topics.put(`/${BOB}/web-interface-smart-device/touch_position`, 'vector2', { x: 0.55, y: 0.5 });
    await clock.advance(50);
    expect(values('/examples/gather-pointers/near_count').at(-1)).toBe(2);
    expect(events).toEqual([]);
  });
});

describe('the session smoothing-chain', () => {
  it('lets a wave flow through four modules', async () => {
    const topic = '/examples/smoothing-chain';
    const { clock, values, events } = await startSession(EXAMPLE_SESSIONS['smoothing-chain']);
    await clock.advance(4_000);
    const mapped = values(`${topic}/mapped`) as number[];
    const smoothed = values(`${topic}/smoothed`) as number[];
    expect(new Set(mapped)).toEqual(new Set([0, 100]));
    expect(smoothed).toHaveLength(mapped.length);
    expect(mapped.length).toBeGreaterThanOrEqual(240);
    const between = smoothed.filter((value) => value > 5 && value < 95);
    expect(between.length).toBeGreaterThan(20);
    expect(Math.min(...smoothed)).toBeGreaterThanOrEqual(0);
    expect(Math.max(...smoothed)).toBeLessThanOrEqual(100);

    const last = (name: string) => values(`${topic}/${name}`).at(-1);
    const window = smoothed.slice(-120);
    expect(last('mean')).toBeCloseTo(window.reduce((sum, v) => sum + v, 0) / window.length, 0);
    expect(last('max')).toBeCloseTo(Math.max(...window), 6);
    expect(last('deviation')).toBeGreaterThan(10);
    expect(events).toEqual([]);
  });
});

describe('the session touch-proximity', () => {
  it('tells phones that come, meet and go [PM-40] [PM-44] [PM-45]', async () => {
    const { clock, topics, values, events } = await startSession(
      EXAMPLE_SESSIONS['touch-proximity'],
    );
    topics.put(`/${ANN}/web-interface-smart-device/touch_position`, 'vector2', { x: 0.5, y: 0.5 });
    await clock.advance(50);
    expect(values('/examples/touch-proximity/near_count').at(-1)).toBe(0);

    topics.put(`/${BOB}/web-interface-smart-device/touch_position`, 'vector2', { x: 0.55, y: 0.5 });
    await clock.advance(50);
    expect(values('/examples/touch-proximity/near_count').at(-1)).toBe(2);
    for (const phone of [ANN, BOB]) {
      expect(values(`/${phone}/vibration_pattern`)).toEqual([100]);
      expect(values(`/${phone}/web-interface-smart-device/is_near`)).toEqual([true]);
    }

    topics.delete(`/${BOB}/web-interface-smart-device/touch_position`);
    await clock.advance(50);
    expect(values(`/${ANN}/web-interface-smart-device/is_near`)).toEqual([true, false]);
    expect(values(`/${BOB}/web-interface-smart-device/is_near`)).toEqual([true, false]);
    expect(events).toEqual([]);
  });
});

describe('a module of the library on a node', () => {
  it.each(PLAIN_MODULES.map(({ name }) => name))('runs with nothing mapped: %s', async (name) => {
    const http = { get: () => Promise.reject(new Error('none')) };
    const { clock, runtime, ids, events } = await startSession(sessionOf(name, [], []), { http });
    runtime.setMode(ids.get(name)!, { frequency: { hertz: 10 } });
    await clock.advance(500);
    const [statistics] = runtime.statistics();
    expect(statistics?.runs).toBeGreaterThan(5);
    expect(statistics?.errors).toBe(0);
    expect(events).toEqual([]);
  });

  it('asks the web through the library of the node', async () => {
    const urls: string[] = [];
    const http = {
      get: (url: string) => {
        urls.push(url);
        return Promise.resolve({ status: 200, text: `{"t":${urls.length}}` });
      },
    };
    const session = sessionOf('http-poller', ['url', 'path'], ['number', 'error']);
    const { clock, topics, values } = await startSession(session, { http });
    topics.put('/path', 'string', 't');
    topics.put('/url', 'string', 'http://thing.local/');
    await clock.advance(2_500);
    expect(urls).toEqual(Array(3).fill('http://thing.local/'));
    expect(values('/number')).toEqual([1, 2, 3]);
    expect(values('/error')).toEqual([]);
  });

  it('cannot be made where a library is missing [PM-4]', async () => {
    const session = sessionOf('http-poller', [], []);
    await expect(startSession(session)).rejects.toMatchObject({ kind: 'library' });
  });

  it('continues with its state after a halt [PM-10]', async () => {
    const session = sessionOf('clock', [], ['count']);
    const { clock, runtime, ids, values } = await startSession(session);
    const id = ids.get('clock')!;
    await clock.advance(100);
    const before = values('/count').length;
    await runtime.halt(id);
    await clock.advance(1_000);
    expect(values('/count')).toHaveLength(before);
    runtime.start(id);
    await clock.advance(100);
    expect(values('/count').slice(before)[0]).toBe(before);
  });

  it('samples on when its mode is changed from trigger to frequency [PM-12]', async () => {
    const session = sessionOf('statistics', ['value', 'windowMs'], ['count']);
    const { clock, topics, runtime, ids, values } = await startSession(session);
    topics.put('/value', 'double', 1);
    await clock.endTurn();
    topics.put('/windowMs', 'double', 0);
    await clock.endTurn();
    expect(values('/count')).toEqual([1, 1]);
    runtime.setMode(ids.get('statistics')!, { frequency: { hertz: 10 } });
    await clock.advance(500);
    expect(values('/count').at(-1)).toBeGreaterThan(4);
  });

  it('takes a float where it says double [PM-31]', async () => {
    const session = sessionOf('map-range', ['value', 'inMax'], ['mapped']);
    const { clock, topics, values, events } = await startSession(session);
    topics.put('/inMax', 'int32', 4);
    topics.put('/value', 'float', 1);
    await clock.endTurn();
    expect(values('/mapped')).toEqual([0.25]);
    expect(events).toEqual([]);
  });
});
