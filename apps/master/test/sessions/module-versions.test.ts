import {
  ModuleVersionOrigin,
  toJson,
  type Init,
  type ModuleVersionRequest,
  type ProcessingModule,
} from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { MemoryStorage } from '../../src/testing/index.ts';
import { doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';

const code = (factor: number) => doubler.onProcessingStringified.replace('2 *', `${factor} *`);

async function save(world: SessionWorld, module: Init<ProcessingModule>) {
  const { error } = await world.master.call({ topic: TOPICS.saveModule, processingModule: module });
  if (error) throw new Error(error.message);
  await world.master.pass();
}

const saveTimes = (world: SessionWorld, factor: number) =>
  save(world, { ...doubler, onProcessingStringified: code(factor) });

async function ask(world: SessionWorld, moduleVersionRequest: Init<ModuleVersionRequest>) {
  return world.master.call({
    topic: '/services/ubii/module_version_list',
    moduleVersionRequest,
  });
}

async function versions(world: SessionWorld, asked: Init<ModuleVersionRequest>) {
  const { moduleVersionList, error } = await ask(world, asked);
  if (error) throw new Error(`${error.code}: ${error.message}`);
  return moduleVersionList!.elements;
}

const codeOf = async (world: SessionWorld, asked: Init<ModuleVersionRequest>) =>
  (await versions(world, asked))[0]!.module?.onProcessingStringified;

describe('versions of a stored module', () => {
  it('come with each save that changes something, newest first [EX-40] [EX-41]', async () => {
    const world = await SessionWorld.create();
    await saveTimes(world, 2);
    world.master.clock.advanceSync(1_000);
    await saveTimes(world, 3);
    await saveTimes(world, 3);
    const list = await versions(world, { name: 'doubler' });
    expect(list).toMatchObject([
      { number: 2, current: true, origin: ModuleVersionOrigin.SAVED, module: undefined },
      { number: 1, current: false },
    ]);
    expect(list[0]!.timeMs).toBeGreaterThan(list[1]!.timeMs);
    expect(list[0]!.byteLength).toBeGreaterThan(100);
    expect(await codeOf(world, { name: 'doubler', number: 1 })).toBe(code(2));
    expect(await codeOf(world, { name: 'doubler', number: 2 })).toBe(code(3));
  });

  it('are restored by saving them, and nothing is lost [EX-44]', async () => {
    const world = await SessionWorld.create();
    await saveTimes(world, 2);
    await saveTimes(world, 3);
    const [first] = await versions(world, { name: 'doubler', number: 1 });
    await save(world, first!.module!);
    const numbers = (await versions(world, { name: 'doubler' })).map(({ number }) => number);
    expect(numbers).toEqual([3, 2, 1]);
    expect(await codeOf(world, { name: 'doubler', number: 3 })).toBe(code(2));
  });

  it('come with edits by hand, with what was there before [EX-41]', async () => {
    const storage = new MemoryStorage();
    const text = (factor: number) =>
      JSON.stringify(
        toJson('ubii.processing.ProcessingModule', {
          ...doubler,
          onProcessingStringified: code(factor),
        }),
      );
    storage.modules.edit('doubler', text(2));
    const world = await SessionWorld.create({ storage });
    storage.modules.edit('doubler', text(3));
    await world.master.pass();
    expect(await versions(world, { name: 'doubler' })).toMatchObject([
      { number: 2, origin: ModuleVersionOrigin.FILE, current: true },
      { number: 1, origin: ModuleVersionOrigin.FOUND },
    ]);
    expect(await codeOf(world, { name: 'doubler', number: 1 })).toBe(code(2));
    await world.master.master.close();
    storage.modules.edit('doubler', text(4));
    const next = await SessionWorld.create({ storage });
    await next.master.pass();
    expect(await versions(next, { name: 'doubler' })).toMatchObject([
      { number: 3, origin: ModuleVersionOrigin.FILE, current: true },
      { number: 2 },
      { number: 1 },
    ]);
  });

  it('outlive the master and the deletion of the module [EX-42]', async () => {
    const storage = new MemoryStorage();
    const world = await SessionWorld.create({ storage });
    await saveTimes(world, 2);
    await world.master.call({
      topic: TOPICS.deleteModule,
      processingModule: { name: 'doubler' },
    });
    const next = await SessionWorld.create({ storage });
    expect(await versions(next, { name: 'doubler' })).toMatchObject([
      { number: 1, current: false },
    ]);
    expect(await codeOf(next, { name: 'doubler', number: 1 })).toBe(code(2));
  });

  it('are at most 50, and 2 MiB [EX-43]', async () => {
    const world = await SessionWorld.create();
    for (let i = 0; i < 60; i++) await saveTimes(world, i);
    const list = await versions(world, { name: 'doubler' });
    expect(list).toHaveLength(50);
    expect([list[0]!.number, list.at(-1)!.number]).toEqual([60, 11]);
    for (let i = 0; i < 4; i++) {
      const large = `${code(i)} // ${'x'.repeat(900_000)}`;
      await save(world, { ...doubler, onProcessingStringified: large });
    }
    expect(await versions(world, { name: 'doubler' })).toHaveLength(2);
  });

  it('leave a history that cannot be read alone [EX-42]', async () => {
    const storage = new MemoryStorage();
    storage.history.edit('module doubler', '{');
    const world = await SessionWorld.create({ storage });
    await saveTimes(world, 2);
    expect((await ask(world, { name: 'doubler' })).error?.code).toBe('not_found');
    expect(storage.history.documents().get('module doubler')?.fault).toBeDefined();
  });

  it.each([
    [{}, 'invalid_argument'],
    [{ name: 'doubler', moduleId: 'x' }, 'invalid_argument'],
    [{ name: 'nothing' }, 'not_found'],
    [{ moduleId: 'nothing' }, 'not_found'],
    [{ name: 'doubler', number: 9 }, 'not_found'],
  ])('answers %j with %s [EX-40]', async (asked, expected) => {
    const world = await SessionWorld.create();
    await saveTimes(world, 2);
    expect((await ask(world, asked)).error?.code).toBe(expected);
  });
});

describe('versions of a module of a session', () => {
  it('come with updates that change it, the first is what it was [EX-41]', async () => {
    const world = await SessionWorld.create();
    const session = await world.ask(TOPICS.start, doubling('/in', '/out'));
    const [module] = session.processingModules;
    const update = async (changes: Init<ProcessingModule>) => {
      const now = await world.get(session);
      await world.ask(TOPICS.update, {
        ...now,
        processingModules: [{ ...now.processingModules[0]!, ...changes }],
      });
    };
    await update({});
    const moduleId = module!.id;
    expect((await ask(world, { moduleId })).error?.code).toBe('not_found');
    await update({ onProcessingStringified: code(5) });
    expect(await versions(world, { moduleId })).toMatchObject([
      { number: 2, origin: ModuleVersionOrigin.SAVED, current: true },
      { number: 1, origin: ModuleVersionOrigin.FOUND, current: false },
    ]);
    expect(await codeOf(world, { moduleId, number: 1 })).toBe(code(2));
    expect(await codeOf(world, { moduleId, number: 2 })).toBe(code(5));
  });
});
