import { decode, encode, NodeExtensionKind, type Init, type ProcessingModule } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import type { Node } from './node.ts';
import { chooseNode } from './placement.ts';

const ours = {
  kind: NodeExtensionKind.NODE,
  runsJavascript: true,
  acceptsWork: true,
  libraries: [] as string[],
  capacity: 1,
  memoryBytes: 0,
  loadsAssets: true,
  records: false,
  isBridge: false,
};

function moduleOf(init: Init<ProcessingModule>): ProcessingModule {
  const format = 'ubii.processing.ProcessingModule';
  return decode(format, encode(format, init));
}

function node(id: string, parts: Partial<Node> = {}): Node {
  return {
    id,
    label: id,
    extension: undefined,
    isDedicated: false,
    isAvailable: true,
    modules: [],
    ...parts,
  };
}

const offered = moduleOf({ name: 'm' });
const code = moduleOf({ name: 'm', onProcessingStringified: '() => 1' });
const master = node('master', {
  isDedicated: true,
  extension: { ...ours, kind: NodeExtensionKind.MASTER },
});
const dedicated = node('dedicated', { isDedicated: true, modules: [offered] });
const tab = node('tab', { extension: ours });
const python = node('python', { modules: [offered] });

function choose(module: ProcessingModule, nodes: Node[], loads: Record<string, number> = {}) {
  return chooseNode(module, nodes, ({ id }) => loads[id] ?? 0)?.id;
}

describe('the master chooses for a module [SE-30]', () => {
  it.each<[string, ProcessingModule, Node[], string | undefined]>([
    ['a dedicated node that offers it', code, [master, tab, python, dedicated], 'dedicated'],
    ['itself, when it has the code', code, [tab, python, master], 'master'],
    ['a node that accepts work, when there is code', code, [python, tab], 'tab'],
    ['any client that offers it', offered, [tab, master, python], 'python'],
    ['no node, when no node can', offered, [tab, master], undefined],
    ['no unavailable node', offered, [{ ...dedicated, isAvailable: false }], undefined],
    [
      'no node that loads no asset sets, for a module that needs some',
      moduleOf({ name: 'm', onProcessingStringified: '() => 1', extension: { assets: ['a'] } }),
      [{ ...tab, extension: { ...ours, loadsAssets: false } }],
      undefined,
    ],
    [
      'no node of ours that accepts no work',
      code,
      [{ ...tab, modules: [code], extension: { ...ours, acceptsWork: false } }],
      undefined,
    ],
    [
      'no node for code of another language',
      moduleOf({ ...code, language: 1 }),
      [master],
      undefined,
    ],
  ])('%s', (_what, module, nodes, chosen) => {
    expect(choose(module, nodes)).toBe(chosen);
  });

  it('not itself for modules it has, but cannot run [PM-4]', () => {
    const needy = moduleOf({ ...code, extension: { libraries: ['http'] } });
    const python3 = moduleOf({ ...code, language: 1 });
    for (const module of [needy, python3]) {
      expect(choose(module, [{ ...master, modules: [module] }])).toBeUndefined();
    }
  });

  it('only nodes with the libraries it needs [PM-4]', () => {
    const needy = moduleOf({ ...code, extension: { libraries: ['http'] } });
    const able = node('able', { extension: { ...ours, libraries: ['http', 'vision'] } });
    expect(choose(needy, [master, tab, able])).toBe('able');
  });

  it('the one with the fewest instances for its capacity', () => {
    const small = node('small', { extension: ours });
    const large = node('large', { extension: { ...ours, capacity: 10 } });
    expect(choose(code, [small, large], { small: 1, large: 9 })).toBe('large');
    expect(choose(code, [small, large], { small: 1, large: 11 })).toBe('small');
  });
});
