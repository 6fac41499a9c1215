import { Re2Patterns } from '@ubii/patterns/re2';
import { fromJson, ModuleEventKind, type ModuleEvent } from '@ubii/proto';
import { FakeClock } from '@ubii/timing/testing';
import { describe, expect, it } from 'vitest';
import {
  defineProcessingModule,
  type AnyModuleDefinition,
} from '../definition/define-processing-module.ts';
import { moduleToWire } from '../definition/module-to-wire.ts';
import { FakeTopics } from '../testing/fake-topics.ts';
import { createInlineSandboxes } from '../testing/inline-sandboxes.ts';
import { ioMapping, type ModuleSketch } from '../testing/module-world.ts';
import { createModuleRuntime } from './create-module-runtime.ts';

/** A runtime that runs the code of modules. */
function createWorld() {
  const clock = new FakeClock();
  const topics = new FakeTopics('node-1');
  const events: ModuleEvent[] = [];
  const runtime = createModuleRuntime({
    nodeId: 'node-1',
    clock,
    topics,
    sandboxes: createInlineSandboxes(),
    patterns: new Re2Patterns(),
    onEvent: (event) => events.push(event),
    onStatus: () => {},
  });
  let ids = 0;
  const begin = async (definition: AnyModuleDefinition, io: Pick<ModuleSketch, 'from' | 'to'>) => {
    const id = `pm-${++ids}`;
    const module = fromJson('ubii.processing.ProcessingModule', {
      ...moduleToWire(definition),
      id,
      sessionId: 'session-1',
    });
    await runtime.create({ module, mapping: ioMapping({ id, ...io }), isTrusted: true });
    runtime.start(id);
    await clock.endTurn();
    return id;
  };
  const published = () => topics.published.map(({ topic, value }) => [topic, value]);
  return { clock, topics, runtime, events, begin, published };
}

const mirror = defineProcessingModule({
  name: 'mirror',
  inputs: { pointers: { format: 'vector2', list: true }, width: 'double' },
  outputs: { mirrored: { format: 'vector2', list: true } },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    const width = inputs.width?.double ?? 1;
    return {
      outputs: {
        mirrored: {
          elements: inputs.pointers!.elements.map(({ vector2, identity }) => ({
            vector2: { x: width - vector2!.x, y: vector2!.y },
            identity,
          })),
        },
      },
    };
  },
});

const counter = defineProcessingModule({
  name: 'counter',
  inputs: {},
  outputs: { count: 'int32' },
  mode: { frequency: { hertz: 10 } },
  createState: () => ({ count: 0 }),
  onProcessing(_deltaTimeMs, _inputs, state) {
    return { outputs: { count: { int32: state.count++ } } };
  },
});

const double = defineProcessingModule({
  name: 'double',
  inputs: { x: 'double' },
  outputs: { y: 'double' },
  mode: { triggerOnInput: {} },
  onProcessing(_deltaTimeMs, inputs) {
    if (inputs.x!.double! < 0) throw new Error('too small');
    return { outputs: { y: { double: 2 * inputs.x!.double! } } };
  },
});

describe('modules with code', () => {
  it('[PM-40] [PM-46] give each player what became of their data, wherever it came from', async () => {
    const world = createWorld();
    await world.begin(mirror, {
      from: {
        pointers: { topicGlob: '/*/pointer', identityMatchPattern: '^/([^/]+)/', identityGroup: 1 },
        width: { constant: { double: 10 } },
      },
      to: { mirrored: { outputTopicFormat: '/{{identity}}/mirrored' } },
    });
    world.topics.put('/ada/pointer', 'vector2', { x: 1, y: 2 });
    world.topics.put('/bob/pointer', 'vector2', { x: 3, y: 4 });
    await world.clock.endTurn();
    expect(world.published()).toEqual([
      ['/ada/mirrored', { x: 9, y: 2 }],
      ['/bob/mirrored', { x: 7, y: 4 }],
    ]);
    expect(world.events).toEqual([]);
  });

  it('[PM-12] keep their state over a halt, and 0 is a value', async () => {
    const world = createWorld();
    const id = await world.begin(counter, { to: { count: '/count' } });
    await world.clock.advance(100);
    await world.runtime.halt(id);
    await world.clock.advance(1000);
    world.runtime.start(id);
    await world.clock.endTurn();
    expect(world.published().map(([, value]) => value)).toEqual([0, 1, 2]);
  });

  it('take numbers of any format through a chain of modules', async () => {
    const world = createWorld();
    await world.begin(double, { from: { x: '/count' }, to: { y: '/y' } });
    await world.begin(double, { from: { x: '/y' }, to: { y: '/z' } });
    world.topics.put('/count', 'double', 3);
    await world.clock.endTurn();
    expect(world.published()).toEqual([
      ['/y', 6],
      ['/z', 12],
    ]);
  });

  it('[PM-13] go on after an error that names its line', async () => {
    const world = createWorld();
    await world.begin(double, { from: { x: '/x' }, to: { y: '/y' } });
    world.topics.put('/x', 'double', -1);
    await world.clock.endTurn();
    world.topics.put('/x', 'double', 1);
    await world.clock.endTurn();
    const { ERROR } = ModuleEventKind;
    const message = expect.stringMatching(/too small/);
    expect(world.events).toMatchObject([{ kind: ERROR, phase: 'onProcessing', message, line: 2 }]);
    expect(world.published()).toEqual([['/y', 2]]);
  });
});
