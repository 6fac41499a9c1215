import { formatsFit, parseModule } from '@ubii/pm-sandbox';
import {
  isExtensionTopic,
  isMasterTopic,
  parseDataFormat,
  type ProcessingModule,
} from '@ubii/proto';
import type { Graph, PortRef } from '../model/graph.ts';
import { portFormat, portOf } from '../model/port-format.ts';
import { inputPort, IN, OUT, outputPort } from '../model/ports.ts';
import type { NewNode } from './new-nodes.ts';

/** Something that can be added, with the port that takes the wire at hand. */
export interface Addable {
  readonly key: string;
  readonly text: string;
  readonly hint: string;
  readonly item: NewNode;
  /** Port of the new node that the wire goes to. */
  readonly port?: string;
}

/** What there is to choose from. */
export interface AddableSources {
  readonly modules: readonly ProcessingModule[];
  readonly topics: readonly { readonly topic: string; readonly format: string }[];
}

/** The end of a wire that looks for another. */
export interface LooseEnd {
  readonly from: PortRef;
  readonly side: 'in' | 'out';
}

const MAX_SHOWN = 60;

/** What fits the words typed, and the wire at hand if there is one. */
export function addables(
  graph: Graph,
  { modules, topics }: AddableSources,
  text: string,
  end: LooseEnd | undefined,
): Addable[] {
  const typed = text.trim();
  const words = typed.toLowerCase().split(/\s+/).filter(Boolean);
  const has = (...texts: string[]): boolean => {
    const all = texts.join(' ').toLowerCase();
    return words.every((word) => all.includes(word));
  };
  const found: Addable[] = [];
  for (const module of modules) {
    if (!has(module.name, module.description)) continue;
    const port = end && fittingPort(graph, module, end);
    if (end !== undefined && port === undefined) continue;
    found.push({
      key: `module ${module.name}`,
      text: module.name,
      hint: 'module',
      item: { kind: 'module', module },
      ...(port !== undefined && { port }),
    });
  }
  const isTopicLegal = end === undefined || graph.nodes.get(end.from.node)?.kind === 'module';
  if (isTopicLegal) {
    const port = end?.side === 'out' ? IN : OUT;
    const wanted = end && portFormat(graph, end.from);
    for (const { topic, format } of topics) {
      if (isMasterTopic(topic) || isExtensionTopic(topic) || !has(topic, format)) continue;
      if (end !== undefined && !formatsFit(parseDataFormat(format), wanted)) continue;
      found.push({
        key: topic,
        text: topic,
        hint: format || 'topic',
        item: { kind: 'topic', topic, format },
        port,
      });
    }
    if (typed !== '' && !/\s/.test(typed) && !topics.some(({ topic }) => topic === typed)) {
      const topic = typed.startsWith('/') ? typed : `/${typed}`;
      found.push({
        key: `new ${topic}`,
        text: `New topic ${topic}`,
        hint: 'topic',
        item: { kind: 'topic', topic, format: wanted ?? '' },
        port,
      });
    }
  }
  if (end === undefined) {
    for (const kind of ['muxer', 'demuxer', 'constant', 'comment', 'frame'] as const) {
      if (has(PART_WORDS[kind]))
        found.push({ key: kind, text: PART_WORDS[kind], hint: '', item: { kind } });
    }
  }
  return found.slice(0, MAX_SHOWN);
}

const PART_WORDS = {
  muxer: 'Muxer',
  demuxer: 'Demuxer',
  constant: 'Value',
  comment: 'Note',
  frame: 'Frame',
} as const;

/** The first port of a module that the wire may go to. */
function fittingPort(
  graph: Graph,
  module: ProcessingModule,
  { from, side }: LooseEnd,
): string | undefined {
  const given = portFormat(graph, from);
  const isList = portOf(graph, from)?.isList === true;
  const { inputs, outputs } = parseModule(module);
  const source = graph.nodes.get(from.node)?.kind;
  const fits = (io: {
    readonly format: Parameters<typeof formatsFit>[0];
    readonly isList: boolean;
  }): boolean => formatsFit(io.format, given) && (io.isList === isList || source === 'topic');
  if (side === 'out') {
    const input = inputs.find(fits);
    return input && inputPort(input.name);
  }
  const output = source === 'module' ? outputs.find(fits) : undefined;
  return output && outputPort(output.name);
}
