import { ProcessingModuleLanguage, type ProcessingModule } from '@ubii/proto';
import { topicAt, topicOfWire } from '../../../live/topics-in-graph.ts';
import type { Graph, PortRef } from '../../../model/graph.ts';
import { moduleNode } from '../../../model/make-node.ts';
import { portOf } from '../../../model/port-format.ts';
import { ioName } from '../../../model/ports.ts';
import { insertionOf } from '../../../model/selection/insert.ts';
import { moduleOf, type Addable } from '../../addable.ts';

/** A module that the values of a topic would reach. */
export interface PreviewTask {
  readonly module: ProcessingModule;
  /** Name of the input. */
  readonly input: string;
  readonly topic: string;
}

/** Returns the topic whose values an entry of the palette would get; undefined without one. */
export function wishedTopic(
  graph: Graph,
  end: PortRef | undefined,
  wireId: string | undefined,
): string | undefined {
  const wire = graph.wires.get(wireId ?? '');
  if (wire !== undefined) return topicOfWire(graph, wire);
  if (end === undefined || portOf(graph, end)?.direction !== 'out') return undefined;
  return topicAt(graph, end);
}

/** Returns what an entry would run on the values of a topic; undefined when a page cannot run it. */
export function previewTask(
  graph: Graph,
  item: Addable | undefined,
  topic: string | undefined,
  wireId: string | undefined,
): PreviewTask | undefined {
  const module = item && moduleOf(item);
  if (topic === undefined || module === undefined || item?.misfit !== undefined) return undefined;
  if (!canRunHere(module)) return undefined;
  const wire = graph.wires.get(wireId ?? '');
  const offered = item?.offer?.kind === 'module' ? item.offer.port : undefined;
  const port = offered ?? (wire && insertionOf(graph, wire, moduleNode(module))?.input);
  const input = module.inputs.find(({ internalName }) => port && internalName === ioName(port));
  if (input === undefined || input.isRecordList) return undefined;
  return { module, input: input.internalName, topic };
}

/** Whether two tasks run the same module on the same values. */
export const isSameTask = (a: PreviewTask, b: PreviewTask): boolean =>
  a.module.name === b.module.name &&
  a.module.onProcessingStringified === b.module.onProcessingStringified &&
  a.input === b.input &&
  a.topic === b.topic;

const { JS, CPP } = ProcessingModuleLanguage;
/** Clients that mean no language send the number of C++. */
const LANGUAGES: ReadonlySet<ProcessingModuleLanguage | undefined> = new Set([JS, CPP, undefined]);

/** Code for browsers that needs nothing of its node, at a rhythm that can be repeated. */
function canRunHere(module: ProcessingModule): boolean {
  const { language, onProcessingStringified, processingMode, extension } = module;
  const needs = [...(extension?.libraries ?? []), ...(extension?.assets ?? [])];
  const isCode = onProcessingStringified !== '' && LANGUAGES.has(language);
  return isCode && !processingMode?.free && needs.length === 0;
}
