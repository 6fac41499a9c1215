import { lazyPatterns, type PatternCompiler } from '@ubii/patterns';
import { mappingNeedsPatterns, type SandboxFactory } from '@ubii/pm-sandbox';
import type { Init, ProcessingModule, Session } from '@ubii/proto';
import { onScopeDispose } from 'vue';
import { completeExample } from '../../../sessions/examples/complete-example.ts';
import type { GalleryEntry } from '../gallery.ts';

/**
 * Shared by all previews of a page: the library, one worker for all modules, and a pattern compiler, loaded on demand.
 */
export interface PreviewKit {
  readonly library: readonly ProcessingModule[];
  readonly sandboxes: SandboxFactory;
  spec(entry: GalleryEntry): Init<Session>;
  /** Returns the complete session with an id for each module. */
  session(entry: GalleryEntry): Session;
  patterns(session: Session): Promise<PatternCompiler>;
}

const NO_PATTERNS: PatternCompiler = {
  compile: () => {
    throw new Error('The session uses no patterns.');
  },
};

/** Loads the kit on first use. Its worker ends with the calling scope. */
export function usePreviewKit(): () => Promise<PreviewKit> {
  let loading: Promise<PreviewKit> | undefined;
  let isOver = false;
  onScopeDispose(() => {
    isOver = true;
    void loading?.then(({ sandboxes }) => sandboxes.close());
  });
  const load = async (): Promise<PreviewKit> => {
    const [{ EXAMPLE_SESSIONS, moduleLibrary }, { createBrowserSandboxes }] = await Promise.all([
      import('@ubii/modules'),
      import('@ubii/pm-sandbox/browser'),
    ]);
    const library = moduleLibrary();
    const sandboxes = createBrowserSandboxes({ maxWorkers: 1 });
    if (isOver) void sandboxes.close();
    const patterns = lazyPatterns();
    return {
      library,
      sandboxes,
      spec: ({ id }) => EXAMPLE_SESSIONS[id],
      session: ({ id }) => completeExample(EXAMPLE_SESSIONS[id], library),
      patterns: (session) =>
        session.ioMappings.some(mappingNeedsPatterns)
          ? patterns.load()
          : Promise.resolve(NO_PATTERNS),
    };
  };
  return () => (loading ??= load());
}
