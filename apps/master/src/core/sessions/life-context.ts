import type { Clock } from '@ubii/timing';
import type { ClientRegistry } from '../clients/client-registry.ts';
import type { Hook } from '../hooks/hook.ts';
import type { Limits } from '../limits/index.ts';
import type { Log } from '../ports/log.ts';
import type { LocalNode } from '../nodes/local-node.ts';
import type { Node } from '../nodes/node.ts';
import type { NodeTable } from '../nodes/node-table.ts';
import type { Session } from './session.ts';
import type { SessionNews } from './session-news.ts';

/** Dependencies of the life of sessions. */
export interface LifeContext {
  readonly clock: Clock;
  readonly limits: Limits;
  readonly log: Log;
  readonly clients: ClientRegistry;
  readonly nodes: NodeTable;
  readonly local: LocalNode;
  readonly news: SessionNews;
  /** Every session there is. */
  readonly sessions: () => Iterable<Session>;
  /** Modules of sessions a node runs now. */
  readonly loadOf: (node: Node) => number;
  /** Called when a session came to another state. */
  readonly onLife: Hook<[session: Session]>;
  /** Called when a session came to another state, or has other modules. */
  readonly onModules: Hook<[session: Session]>;
}
