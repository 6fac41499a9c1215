import type { Session } from '@ubii/proto';
import { useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { sessionLocation } from '../../locations/session-location.ts';
import { useSessionActions } from '../../sessions/actions/useSessionActions.ts';
import type { LastingSession } from '../../sessions/own/lasting-session.ts';
import { useOwnedSession } from '../../sessions/own/useOwnedSession.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { GALLERY, type GalleryEntry } from './gallery.ts';
import { gallerySession, inputClient, isSessionOf, withInputsOf } from './gallery-session.ts';
import { usePageInputs } from './inputs/page-inputs.ts';
import type { PreviewKit } from './preview/preview-kit.ts';

/** The gallery's sessions on the master, and their actions. */
export interface GallerySessions {
  /** The session of an example, which all clients share: a second start opens the existing one. */
  of(entry: GalleryEntry): LastingSession;
  /** Creates the session if the master has none, starts it, and opens its graph. */
  start(entry: GalleryEntry): Promise<void>;
  /** Creates the session if the master has none, and opens its graph. */
  open(entry: GalleryEntry): Promise<void>;
  remove(entry: GalleryEntry): Promise<void>;
}

export function useGallerySessions(
  loadKit: () => Promise<Pick<PreviewKit, 'spec'>>,
): GallerySessions {
  const { client, clients } = useConnection();
  const router = useRouter();
  const actions = useSessionActions();
  const pageInputs = usePageInputs();

  const isOurs = (entry: GalleryEntry, session: Session): boolean => {
    const giver = inputClient(entry, session);
    return giver === undefined || giver === client.id;
  };
  const owned = new Map(
    GALLERY.map((entry) => [
      entry.id,
      useOwnedSession({
        life: 'stored',
        calls: actions.calls,
        isOwn: (session) => isSessionOf(entry, session),
        spec: async () => gallerySession(entry, (await loadKit()).spec(entry), client.id),
        // This page provides its inputs, unless another page does.
        async prepare(session) {
          const giver = inputClient(entry, session);
          const isGiven = giver !== undefined && isAlive(session) && clients.find(giver);
          if (isOurs(entry, session) || isGiven) return session;
          return actions.calls.update(session, {
            ioMappings: withInputsOf(entry, session, client.id),
          });
        },
      }),
    ]),
  );
  const of = (entry: GalleryEntry): LastingSession => {
    const session = owned.get(entry.id);
    if (session === undefined) throw new Error(`The gallery has no example "${entry.id}".`);
    return session;
  };
  async function show(session: Session | undefined): Promise<void> {
    if (session) await router.push(sessionLocation(session.id));
  }

  return {
    of,
    async start(entry) {
      const session = await of(entry).start((ready) => {
        if (!isOurs(entry, ready)) return;
        pageInputs.give(
          ready.id,
          entry.inputs.map(({ input }) => input),
        );
      });
      await show(session);
    },
    open: async (entry) => show(await of(entry).create()),
    async remove(entry) {
      const session = of(entry).session.value;
      if (session) await actions.remove(session);
    },
  };
}
