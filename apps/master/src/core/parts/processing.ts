import type { FileNews } from '../library/file-news.ts';
import type { ModuleHistory } from '../library/module-history.ts';
import type { ModuleLibrary } from '../library/module-library.ts';
import type { LocalNode } from '../nodes/local-node.ts';
import type { NodeTable } from '../nodes/node-table.ts';
import type { NodeReports } from '../sessions/node-reports.ts';
import type { ModuleReload } from '../sessions/reload-modules.ts';
import type { SessionLibrary } from '../sessions/session-library.ts';
import type { Sessions } from '../sessions/sessions.ts';

/** Everything about sessions, processing modules and nodes. */
export interface Processing {
  readonly sessions: Sessions;
  readonly modules: ModuleLibrary;
  readonly sessionLibrary: SessionLibrary;
  readonly nodes: NodeTable;
  readonly localNode: LocalNode;
  readonly reports: NodeReports;
  readonly files: FileNews;
  readonly reload: ModuleReload;
  readonly history: ModuleHistory;
  /** A node says that a module runs, or has ended. Returns false when no session has it there [SE-32]. */
  handleReport(nodeId: string, moduleId: string, isRunning: boolean): boolean;
  /** A client can be reached, or no longer [SE-31]. */
  handlePresence(clientId: string): void;
  /** Ends all modules and workers. */
  close(): Promise<void>;
}
