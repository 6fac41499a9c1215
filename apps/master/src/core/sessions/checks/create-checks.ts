import { type SessionProblem, dataFormatOfField, isUuid } from '@ubii/proto';
import type { CompiledPattern, PatternCompiler } from '@ubii/patterns';
import { cannotRun, isMaster, type Node, offerOf } from '../../nodes/node.ts';
import type { NodeTable } from '../../nodes/node-table.ts';
import { chooseNode } from '../../nodes/placement.ts';
import { quote } from '../../texts/quote.ts';
import type { DraftModule } from '../complete-modules.ts';
import { errorProblem, warningProblem } from '../problems.ts';
import { about, type CheckContext } from './check-context.ts';
import { hasCode } from './check-modules.ts';
import type { ClientRegistry } from '../../clients/client-registry.ts';
import type { DeviceRegistry } from '../../devices/device-registry.ts';
import type { Limits } from '../../limits/index.ts';
import type { TopicTable } from '../../topics/topic-table.ts';

/** Returns the problem with the node of a module, chosen in the session or by the master [SE-4] [SE-30]. */
export function nodeProblem(nodes: NodeTable, draft: DraftModule): SessionProblem | undefined {
  const { spec, requestedNodeId } = draft;
  if (requestedNodeId === undefined) return chosenProblem(nodes, draft);
  const node = nodes.get(requestedNodeId);
  const found = { ...about(draft), nodeId: requestedNodeId };
  if (node === undefined) {
    return errorProblem({
      ...found,
      code: 'unknown_node',
      message: `The module ${quote(spec.name)} is assigned to ${quote(requestedNodeId)}, but no registered client has this id. /services/ubii/node_list lists the nodes.`,
    });
  }
  const reason = isMaster(node) ? masterCannot(node, draft) : cannotRun(node, spec);
  if (reason !== undefined) return cannot(draft, node, reason);
  if (node.isAvailable) return undefined;
  return warningProblem({
    ...found,
    code: 'node_unavailable',
    message: `The node ${quote(node.label)} is not connected. The module ${quote(spec.name)} starts when it reconnects.`,
  });
}

/** Nodes offer the module, but no available node can be chosen. */
function chosenProblem(nodes: NodeTable, draft: DraftModule): SessionProblem | undefined {
  const { spec } = draft;
  if (chooseNode(spec, nodes.list(), () => 0) !== undefined) return undefined;
  if (!hasCode(draft)) return undefined;
  const reasons = nodes
    .list()
    .map((node) => cannotRun(node, spec) ?? 'accepts only modules that a session assigns to it')
    .slice(0, 1);
  return errorProblem({
    ...about(draft),
    code: 'node_cannot_run',
    message: `No connected node can run the module ${quote(spec.name)}: the master ${reasons.join('')}. Start a node that can run it, or choose one.`,
  });
}

function masterCannot(node: Node, draft: DraftModule): string | undefined {
  return hasCode(draft) ? cannotRun(node, draft.spec) : 'has no code for it';
}

function cannot(draft: DraftModule, node: Node, reason: string): SessionProblem {
  return errorProblem({
    ...about(draft),
    code: 'node_cannot_run',
    message: `The node ${quote(node.label)} cannot run the module ${quote(draft.spec.name)}: it ${reason}.`,
    nodeId: node.id,
  });
}

/** Names of clients leave with them, and the ids of clients tell people nothing. */
const GONE_CLIENT = 'a client that has left';

/** State of the master for the checks. */
interface SurroundingsContext {
  readonly patterns: PatternCompiler;
  readonly devices: DeviceRegistry;
  readonly nodes: NodeTable;
  readonly topics: TopicTable;
  readonly clients: Pick<ClientRegistry, 'get'>;
  readonly limits: Limits;
}

export function createChecks(context: SurroundingsContext): CheckContext {
  const { patterns, devices, nodes, topics, clients, limits } = context;
  const compile = (source: string): CompiledPattern | string => {
    if (source.length > limits.patternLength) {
      return `it has more than ${limits.patternLength} characters (limit patternLength)`;
    }
    try {
      return patterns.compile(source);
    } catch (error) {
      return error instanceof Error ? error.message : String(error);
    }
  };
  return {
    patternFault(source) {
      const compiled = compile(source);
      return typeof compiled === 'string' ? compiled : undefined;
    },
    matcher(source) {
      const compiled = compile(source);
      return typeof compiled === 'string' ? undefined : (text) => compiled.test(text);
    },
    publishers: (topic) => devices.publishersOf(topic),
    retainedFormat(topic) {
      const entry = topics.get(topic);
      return entry?.record === undefined ? undefined : dataFormatOfField(entry.valueField);
    },
    hasRecord: (topic) => topics.get(topic)?.record !== undefined,
    nameTopic(topic) {
      const [, root = '', ...rest] = topic.split('/');
      const client = clients.get(root);
      const owner = client === undefined ? GONE_CLIENT : `the client ${quote(client.label)}`;
      return (client === undefined && !isUuid(root)) || rest.length === 0
        ? quote(topic)
        : `${quote(rest.join('/'))} of ${owner}`;
    },
    nodeProblem: (draft) => nodeProblem(nodes, draft),
    isOffered: (name) => nodes.list().some((node) => offerOf(node, name) !== undefined),
    topicBytes: limits.topicBytes,
  };
}
