import { ConnectionError } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { useRouter } from 'vue-router';
import { randomUuid } from '../../connection/random-uuid.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import type { SessionCalls } from '../actions/session-calls.ts';
import { sessionLocation } from '../routes.ts';
import { sessionCopy, sessionSpec } from '../text/session-spec.ts';
import { useSessionDraft } from '../text/useSessionDraft.ts';
import { importSession, type TextFile } from './session-file.ts';

/**
 * Makes sessions of files. What is wrong with one is shown beside its text, so that it can be put
 * right.
 */
export function useSessionImport(
  calls: SessionCalls,
): (files: readonly TextFile[]) => Promise<void> {
  const router = useRouter();
  const toasts = useToasts();
  const draft = useSessionDraft();

  async function take(file: TextFile): Promise<string | undefined> {
    const read = importSession(file);
    if (read.kind === 'broken') return undefined;
    try {
      const session = await calls.create(sessionCopy(sessionSpec(read.session), randomUuid));
      return session.id;
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      return undefined;
    }
  }

  return async (files) => {
    const ids: string[] = [];
    for (const file of files) {
      const id = await take(file);
      if (id === undefined) {
        draft.value = file.text;
        await router.push({ path: '/sessions/new', query: { try: '1' } });
        return;
      }
      ids.push(id);
    }
    const [only] = ids;
    if (ids.length === 1 && only !== undefined) await router.push(sessionLocation(only));
    else if (ids.length > 1) toasts.show(`Imported ${ids.length} sessions`);
  };
}
