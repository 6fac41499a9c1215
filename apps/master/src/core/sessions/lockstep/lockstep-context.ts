import type { PatternCompiler } from '@ubii/patterns';
import type { TopicPort } from '@ubii/pm-sandbox';
import type { Clock } from '@ubii/timing';
import type { ClientRegistry } from '../../clients/client-registry.ts';
import type { Limits } from '../../limits/index.ts';
import type { LocalNode } from '../../nodes/local-node.ts';
import type { NodeTable } from '../../nodes/node-table.ts';
import type { PublishingClient } from '../../topics/publication.ts';
import type { SessionNews } from '../session-news.ts';

/** Dependencies of lockstep passes. */
export interface LockstepContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly clients: ClientRegistry;
  readonly nodes: NodeTable;
  readonly local: LocalNode;
  readonly news: SessionNews;
  readonly topics: TopicPort;
  readonly patterns: PatternCompiler;
  /** Publishes a complete record for a node: as the client that put it out, or as the master. */
  readonly publish: (
    record: Uint8Array,
    publisher: PublishingClient | undefined,
    sessionId: string,
  ) => void;
}
