import type { Component, DataFormat, SessionProblem } from '@ubii/proto';
import type { DraftModule } from '../complete-modules.ts';

/** State of the master that the checks of a session need. All members are cheap. */
export interface CheckContext {
  /** Why the text is no regular expression of RE2, in a few words; undefined when it is one. */
  patternFault(source: string): string | undefined;
  /** Tells whether an unanchored regular expression matches; undefined when the text is none. */
  matcher(source: string): ((text: string) => boolean) | undefined;
  /** Registered components that publish on this topic. */
  publishers(topic: string): readonly Component[];
  /** Data format of the value the topic has now; undefined when it has none, or of no known format. */
  retainedFormat(topic: string): DataFormat | undefined;
  hasRecord(topic: string): boolean;
  /** A topic in a message: in quotes, and with the name of the client whose id it begins with instead of that. */
  nameTopic(topic: string): string;
  /** Problem of running this module on this node; undefined when there is none. */
  nodeProblem(draft: DraftModule): Omit<SessionProblem, 'path'> | undefined;
  /** True when a node or the library has code for a module of this name. */
  isOffered(name: string): boolean;
  readonly topicBytes: number;
}

/** One of the checks: everything it finds in the modules of a session. */
export type Check = (
  modules: readonly DraftModule[],
  context: CheckContext,
) => Iterable<SessionProblem>;

/** Members of a problem that identify its module. */
export function about({ spec }: DraftModule): { moduleId: string; moduleName: string } {
  return { moduleId: spec.id, moduleName: spec.name };
}
