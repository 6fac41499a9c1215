import type { CompiledPattern, PatternCompiler } from '@ubii/patterns';
import { dataFormatOfField, isUuid } from '@ubii/proto';
import type { ClientRegistry } from '../../clients/client-registry.ts';
import type { DeviceRegistry } from '../../devices/device-registry.ts';
import type { Limits } from '../../limits/index.ts';
import { offerOf } from '../../nodes/node.ts';
import type { NodeTable } from '../../nodes/node-table.ts';
import { quote } from '../../texts/quote.ts';
import type { TopicTable } from '../../topics/topic-table.ts';
import type { CheckContext } from './check-context.ts';
import { nodeProblem } from './node-problem.ts';

/** Names of clients leave with them, and the ids of clients tell people nothing. */
const GONE_CLIENT = 'a client that has left';

/** State of the master for the checks. */
export interface ChecksParts {
  readonly patterns: PatternCompiler;
  readonly devices: DeviceRegistry;
  readonly nodes: NodeTable;
  readonly topics: TopicTable;
  readonly clients: Pick<ClientRegistry, 'get'>;
  readonly limits: Limits;
}

export function createChecks(parts: ChecksParts): CheckContext {
  const { patterns, devices, nodes, topics, clients, limits } = parts;
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
