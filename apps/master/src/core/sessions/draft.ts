import type { IOMapping, ProcessingModule, Session } from '@ubii/proto';

/** One module of a session on its way into being, with its mapping. */
export interface DraftModule {
  /** Complete [SE-1], but for the node the master will choose. */
  spec: ProcessingModule;
  /** Its one mapping [SE-2]. */
  mapping: IOMapping;
  /** The node that the session names; empty when the master chooses. */
  wishedNodeId: string;
  /** Path in the request, such as `processingModules[0]`. */
  readonly path: string;
  /** Path of its mapping in the request; the path it would have if there is none. */
  mappingPath: string;
  /** The source is from the library, so that it needs no check [PM-64]. */
  isLibraryCode: boolean;
}

/** Content of a session, before and during its life. */
export interface SessionDraft {
  readonly name: string;
  readonly tags: readonly string[];
  readonly description: string;
  readonly authors: readonly string[];
  readonly editable: boolean;
  readonly startWithMaster: boolean;
  readonly lockstepHertz: number;
  readonly editorJson: string;
  readonly modules: readonly DraftModule[];
}

/** Settings of the session as a whole in a request. */
export function describeSession(message: Session): Omit<SessionDraft, 'modules'> {
  const { name, tags, description, authors, editable, extension } = message;
  return {
    name,
    tags,
    description,
    authors,
    editable,
    startWithMaster: extension?.startWithMaster ?? false,
    lockstepHertz: extension?.lockstepHertz ?? 0,
    editorJson: extension?.editorJson ?? '',
  };
}
