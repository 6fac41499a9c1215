import { BridgeOutcome, ServiceError } from '@ubii/proto';
import { flushPromises } from '@vue/test-utils';
import { effectScope, ref } from 'vue';
import { afterAll, describe, expect, it, onTestFinished, vi } from 'vitest';
import type { WrittenMapping } from './model/mapping-changes.ts';
import { useBridgeMappings } from './useBridgeMappings.ts';

// Test files share modules: reset them before and after mocking.
const world = vi.hoisted(() => {
  vi.resetModules();
  return {
    call: (_name: string, _request: object): Promise<object> => Promise.reject(new Error()),
  };
});
vi.mock('../connection/useConnection.ts', async () => {
  const { ref: refOf } = await import('vue');
  const isConnected = refOf(true);
  const call = (name: string, request: object) => world.call(name, request);
  return { useConnection: () => ({ client: { id: 'page', call }, isConnected }) };
});
afterAll(() => {
  vi.doUnmock('../connection/useConnection.ts');
  vi.resetModules();
});

const { BRIDGE_OUTCOME_SAVED, BRIDGE_OUTCOME_CONFLICT, BRIDGE_OUTCOME_REFUSED } = BridgeOutcome;
const heat = { name: 'heat', direction: 'in', foreign: 'heat', topic: '/heat', format: 'double' };
const lamp = { name: 'lamp', direction: 'out', foreign: 'lamp', topic: '/lamp' };

/** A bridge in memory with these mappings, and a page that has loaded them. */
async function open(...list: WrittenMapping[]) {
  const bridge = { list, number: 1, problems: [] as object[], sets: [] as object[] };
  const reply = (outcome = 0) => ({
    protocol: 'mqtt',
    mappingsJson: JSON.stringify(bridge.list),
    file: 'bridge.json',
    revision: `r${bridge.number}`,
    fileExists: true,
    fileProblem: '',
    outcome,
    problems: bridge.problems,
    matches: [],
    moreMatches: 0,
  });
  const revision = ref('r1');
  let loads = 0;
  world.call = async (name, request) => {
    if (name === 'bridgeMappingsGet') loads += 1;
    if (name !== 'bridgeMappingsSet') return reply();
    bridge.sets.push(request);
    const { mappingsJson, revision: of } = request as { mappingsJson: string; revision: string };
    if (of !== `r${bridge.number}`) return reply(BRIDGE_OUTCOME_CONFLICT);
    if (bridge.problems.length > 0) return reply(BRIDGE_OUTCOME_REFUSED);
    bridge.list = JSON.parse(mappingsJson) as WrittenMapping[];
    bridge.number += 1;
    return reply(BRIDGE_OUTCOME_SAVED);
  };
  const scope = effectScope();
  onTestFinished(() => scope.stop());
  const store = scope.run(() => useBridgeMappings('hall', () => revision.value))!;
  await flushPromises();
  return { store, bridge, revision, loads: () => loads };
}
const change = (mapping: WrittenMapping) =>
  ({ kind: 'replace', before: heat, mapping, index: 0 }) as const;

describe('mappings of a bridge on a page', () => {
  it('are loaded, and again when the bridge has others', async () => {
    const { store, bridge, revision, loads } = await open(heat);
    expect(store.loaded.value).toMatchObject({ list: [heat], revision: 'r1' });
    bridge.list = [lamp];
    bridge.number = 2;
    revision.value = 'r2';
    await flushPromises();
    expect(store.loaded.value?.list).toEqual([lamp]);
    expect(loads()).toBe(2);
  });

  it('are saved in the name of the page [BR-82]', async () => {
    const { store, bridge } = await open(heat);
    const hot = { ...heat, topic: '/hot' };
    expect(await store.save(change(hot))).toEqual({ kind: 'saved', index: 0 });
    expect(bridge.list).toEqual([hot]);
    expect(bridge.sets).toMatchObject([{ targetId: 'hall', clientId: 'page', revision: 'r1' }]);
  });

  it('are saved on top of what others did to other mappings meanwhile [BR-82]', async () => {
    const { store, bridge } = await open(heat);
    bridge.list = [lamp, heat];
    bridge.number = 7;
    const hot = { ...heat, topic: '/hot' };
    expect(await store.save(change(hot))).toEqual({ kind: 'saved', index: 1 });
    expect(bridge.list).toEqual([lamp, hot]);
  });

  it('are not saved over what others did to the same mapping [BR-82]', async () => {
    const { store, bridge } = await open(heat);
    const theirs = { ...heat, topic: '/theirs' };
    bridge.list = [theirs];
    bridge.number = 7;
    expect(await store.save(change({ ...heat, topic: '/mine' }))).toEqual({ kind: 'conflict' });
    expect(bridge.list).toEqual([theirs]);
  });

  it('are refused with what is wrong with the changed one, if that is known [BR-82]', async () => {
    const { store, bridge } = await open(heat, lamp);
    const problem = (index: number) => ({ index, member: 'topic', message: `no. ${index}` });
    bridge.problems = [problem(0), problem(1)];
    const refused = await store.save(change({ ...heat, topic: '' }));
    expect(refused).toEqual({ kind: 'refused', problems: [problem(0)] });
    bridge.problems = [problem(1)];
    expect(await store.save(change(heat))).toMatchObject({ problems: [problem(1)] });
  });

  it('say why they cannot be loaded or saved', async () => {
    const { store, revision } = await open(heat);
    const text = 'The bridge "Hall" did not answer within 5 s.';
    world.call = () => Promise.reject(new ServiceError('unavailable', text));
    expect(await store.save(change(lamp))).toEqual({ kind: 'failed', message: text });
    revision.value = 'r2';
    await flushPromises();
    expect(store.failure.value).toBe(text);
  });
});
