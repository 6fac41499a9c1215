import { fromJson, type ProcessingModule, type Session } from '@ubii/proto';
import { graphOf } from '../graph-of.ts';
import type { Graph } from '../graph.ts';

/** Data formats by port name; `[]` after the format marks a list. */
export type Ios = Readonly<Record<string, string>>;

/** Returns a module for tests, with its name as its id. */
export function aModule(name: string, inputs: Ios = {}, outputs: Ios = {}): ProcessingModule {
  const ios = (all: Ios): object[] =>
    Object.entries(all).map(([internalName, format]) => ({
      internalName,
      messageFormat: format.replace('[]', ''),
      isRecordList: format.endsWith('[]'),
    }));
  return fromJson('ubii.processing.ProcessingModule', {
    id: name,
    name,
    inputs: ios(inputs),
    outputs: ios(outputs),
    onProcessingStringified: '() => ({})',
  });
}

/** Returns a session of these modules; mappings are `module.io: /topic`, or a muxer, demuxer or constant. */
export function aSessionOf(
  modules: readonly ProcessingModule[],
  mappings: Readonly<Record<string, string | object>> = {},
): Session {
  const ioMappings = modules.map(({ id, name, inputs }) => {
    const own = Object.entries(mappings).filter(([key]) => key.startsWith(`${id}.`));
    const ends = own.map(([key, end]) => {
      const io = key.slice(id.length + 1);
      const isInput = inputs.some(({ internalName }) => internalName === io);
      const member = typeof end === 'string' ? { topic: end } : end;
      return { isInput, mapping: { [isInput ? 'inputName' : 'outputName']: io, ...member } };
    });
    return {
      processingModuleId: id,
      processingModuleName: name,
      inputMappings: ends.filter(({ isInput }) => isInput).map(({ mapping }) => mapping),
      outputMappings: ends.filter(({ isInput }) => !isInput).map(({ mapping }) => mapping),
    };
  });
  return fromJson('ubii.sessions.Session', {
    id: 'session',
    name: 'Test',
    processingModules: modules,
    ioMappings,
  });
}

export function aGraphOf(...parts: Parameters<typeof aSessionOf>): Graph {
  return graphOf(aSessionOf(...parts));
}

/** Wires as `from > to`, ports of modules by name: `a.out > b.in`, sorted. */
export function wiresIn(graph: Graph): string[] {
  const end = ({ node, port }: { node: string; port: string }): string =>
    node.startsWith('module:') ? `${node.slice(7)}.${port.replace(/^\w+:/, '')}` : node;
  return [...graph.wires.values()]
    .map(({ from, to, via }) => `${end(from)} > ${end(to)}${via === undefined ? '' : ` (${via})`}`)
    .sort();
}

/** Returns the port with a short name: `a.in`. */
export function ref(graph: Graph, short: string): { node: string; port: string } {
  const at = short.lastIndexOf('.');
  const node = `module:${short.slice(0, at)}`;
  const name = short.slice(at + 1);
  const port = graph.nodes.get(node)?.ports.find((one) => one.name === name);
  if (port !== undefined) return { node, port: port.id };
  const own = graph.nodes.get(short)?.ports[0];
  if (own === undefined) throw new Error(`no port ${short}`);
  return { node: short, port: own.id };
}
