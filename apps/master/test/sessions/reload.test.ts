import { SessionState, type Init, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { MemoryStorage } from '../../src/testing/index.ts';
import { codes, doubler, doubling, SessionWorld, TOPICS } from './session-world.ts';

const tripler = {
  ...doubler,
  onProcessingStringified: doubler.onProcessingStringified.replace('2 *', '3 *'),
};

async function setup() {
  const storage = new MemoryStorage();
  const world = await SessionWorld.create({ storage });
  const save = async (processingModule: Init<ProcessingModule>): Promise<void> => {
    const reply = await world.master.call({ topic: TOPICS.saveModule, processingModule });
    if (reply.error) throw new Error(reply.error.message);
    await world.master.pass(10);
  };
  await save(doubler);
  const session = await world.ask(TOPICS.start, {
    ...doubling('/in', '/out'),
    processingModules: [{ name: 'doubler' }],
  });
  const answer = async (): Promise<unknown> => {
    world.ada.publish('/in', 'double', 1);
    await world.master.pass(10);
    return world.value('/out');
  };
  expect(await answer()).toBe(2);
  return { world, storage, save, session, answer };
}

describe('a stored module that changes [SE-26]', () => {
  it('is what running sessions continue with, without losing the session', async () => {
    const { world, save, session, answer } = await setup();
    await save(tripler);
    expect(await answer()).toBe(3);
    const after = await world.get(session);
    expect(after.id).toBe(session.id);
    expect(after.extension).toMatchObject({ state: SessionState.SESSION_RUNNING, problems: [] });
    expect(after.processingModules[0]?.id).toBe(session.processingModules[0]?.id);
  });

  it('may be a file that was changed by hand [SE-23]', async () => {
    const { world, storage, answer } = await setup();
    const { json } = storage.modules.documents().get('doubler')!;
    storage.modules.edit('doubler', JSON.stringify(json).replace('2 *', '5 *'));
    await world.master.pass(10);
    expect(await answer()).toBe(5);
  });

  it('is left alone by sessions that changed it themselves', async () => {
    const { world, save, session, answer } = await setup();
    const own = await world.get(session);
    own.processingModules[0]!.onProcessingStringified =
      '() => ({ outputs: { out: { double: 7 } } })';
    await world.ask(TOPICS.update, own);
    await save(tripler);
    expect(await answer()).toBe(7);
  });

  it('is not taken by a session whose mappings it breaks, which says so', async () => {
    const { world, save, session, answer } = await setup();
    await save({ ...tripler, inputs: [{ internalName: 'other', messageFormat: 'double' }] });
    expect(await answer()).toBe(2);
    const { extension } = await world.get(session);
    expect(codes(extension?.problems)).toEqual(['module_not_reloaded']);
    await save(tripler);
    expect(await answer()).toBe(3);
    expect((await world.get(session)).extension?.problems).toEqual([]);
  });
});
