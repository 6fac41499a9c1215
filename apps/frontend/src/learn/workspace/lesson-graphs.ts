import { fromJson, type ProcessingModule, type Session } from '@ubii/proto';
import { applyCommand } from '../../graph/model/commands/apply-command.ts';
import type { GraphCommand } from '../../graph/model/commands/graph-command.ts';
import { graphOf } from '../../graph/model/graph-of.ts';
import type { Graph } from '../../graph/model/graph.ts';
import { topicNode, topicNodeId } from '../../graph/model/make-node.ts';
import { newModuleNode, newMuxerNode } from '../../graph/model/new-node.ts';
import { IN, inputPort, OUT, outputPort } from '../../graph/model/ports.ts';
import { sessionOf } from '../../graph/model/session-of.ts';
import { lessonSession, lessonTopic, pointerTopic, TOUCH_POSITION } from '../lessons/topics.ts';
import type { GraphAnswer, Lesson } from '../model/lesson.ts';

/** Parts of a lesson's graph. */
export interface GraphParts {
  readonly clientId: string;
  readonly library: readonly ProcessingModule[];
  /** Returns a new UUID. */
  readonly uuid: () => string;
}

export type LessonGraph = 'mirror' | 'many-phones';

const NAMES: Readonly<Record<LessonGraph, string>> = {
  mirror: 'mirror',
  'many-phones': 'many-phones',
};
const MODULES: Readonly<Record<LessonGraph, string>> = {
  mirror: 'mirror-pointer',
  'many-phones': 'touch-proximity',
};

export const graphSessionName = (kind: LessonGraph, clientId: string): string =>
  lessonSession(clientId, NAMES[kind]);

/** Returns the node of the lesson's module, whatever its id. */
function moduleNodeOf(graph: Graph): string {
  const found = [...graph.nodes.values()].find(({ kind }) => kind === 'module');
  return found?.id ?? '';
}

/** Returns the command for the answer of a step; undefined when there is nothing to wire. */
export function graphCommand(
  answer: GraphAnswer,
  graph: Graph,
  clientId: string,
): GraphCommand | undefined {
  const node = moduleNodeOf(graph);
  switch (answer) {
    case 'wire-in': {
      const from = { node: topicNodeId(pointerTopic(clientId)), port: OUT };
      return { kind: 'connect', from, to: { node, port: inputPort('pointer') } };
    }
    case 'wire-out': {
      const to = { node: topicNodeId(lessonTopic(clientId, 'mirrored')), port: IN };
      return { kind: 'connect', from: { node, port: outputPort('mirrored') }, to };
    }
    case 'mirror':
      return { kind: 'setConstant', node, input: 'mirrorX', json: '{"bool":true}' };
    case 'start':
      return undefined;
  }
}

function addCommand(kind: LessonGraph, { clientId, library, uuid }: GraphParts): GraphCommand {
  const module = library.find(({ name }) => name === MODULES[kind]);
  if (module === undefined) throw new Error(`The library has no module ${MODULES[kind]}.`);
  if (kind === 'mirror') {
    const nodes = [
      topicNode(pointerTopic(clientId), { position: { x: 0, y: 40 }, format: 'vector2' }),
      newModuleNode(module, uuid(), { position: { x: 280, y: 0 } }),
      topicNode(lessonTopic(clientId, 'mirrored'), {
        position: { x: 560, y: 40 },
        format: 'vector2',
      }),
    ];
    return { kind: 'add', nodes };
  }
  const constants = new Map([
    ['distance', '{"double":0.2}'],
    // A touch is valid until the next one.
    ['maxAgeMs', '{"double":0}'],
  ]);
  const muxer = newMuxerNode(
    uuid(),
    { name: 'fingers of all phones', dataType: 'vector2', topicGlob: `/*${TOUCH_POSITION}` },
    { position: { x: 0, y: 0 } },
  );
  muxer.mux.identityMatchPattern = '^/([^/]+)/';
  const moduleNode = newModuleNode(module, uuid(), { position: { x: 216, y: 0 }, constants });
  const near = topicNode(lessonTopic(clientId, 'near'), {
    position: { x: 432, y: 40 },
    format: 'int32',
  });
  const wires: GraphCommand[] = [
    {
      kind: 'connect',
      from: { node: muxer.id, port: OUT },
      to: { node: moduleNode.id, port: inputPort('touches') },
    },
    {
      kind: 'connect',
      from: { node: moduleNode.id, port: outputPort('nearCount') },
      to: { node: near.id, port: IN },
    },
  ];
  const add: GraphCommand = { kind: 'add', nodes: [muxer, moduleNode, near] };
  return { kind: 'all', label: '', commands: [add, ...wires] };
}

/** Returns the session of a lesson after some of its answers. */
export function lessonSessionAt(
  kind: LessonGraph,
  answers: readonly GraphAnswer[],
  parts: GraphParts,
): Session {
  const { clientId } = parts;
  const base = fromJson('ubii.sessions.Session', { name: graphSessionName(kind, clientId) });
  let { graph } = applyCommand(graphOf(base), addCommand(kind, parts));
  for (const answer of answers) {
    const command = graphCommand(answer, graph, clientId);
    if (command !== undefined) ({ graph } = applyCommand(graph, command));
  }
  return sessionOf(graph, base);
}

/** Returns the answers of the steps before this one, which determine wires and whether the session runs. */
export function answersBefore(lesson: Lesson, step: number): readonly GraphAnswer[] {
  return lesson.steps
    .slice(0, step)
    .flatMap(({ answer }) => (answer.kind === 'graph' ? [answer.edit] : []));
}
