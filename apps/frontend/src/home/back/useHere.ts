import { ClientState, type Client } from '@ubii/proto';
import { computed, type ComputedRef } from 'vue';
import { awaySinceMs } from '../../clients/model/client-facts.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { useMarks } from '../../marks/useMarks.ts';
import type { PlayerIdentity } from '../../players/player-identity.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { formatAge } from '../../ui/readouts/format-time.ts';
import { hereFact, type HereFact } from './here-fact.ts';

/** A client in the list of who is here. */
export interface HereRow {
  readonly client: Client;
  readonly player: PlayerIdentity;
  readonly fact: HereFact;
  readonly isAway: boolean;
  readonly isSelf: boolean;
}

const FRESH_INTERVAL_MS = 2000;

/** Who is here, those that do not answer last; `undefined` until known. */
export function useHere(): ComputedRef<readonly HereRow[] | undefined> {
  const { client, clients, sessions, master } = useConnection();
  const { markOf } = useMarks();
  clients.keepFresh(FRESH_INTERVAL_MS);
  const modules = computed(() => {
    const counts = new Map<string, number>();
    for (const session of (sessions.list.value ?? []).filter(isAlive)) {
      for (const { nodeId } of session.processingModules)
        counts.set(nodeId, (counts.get(nodeId) ?? 0) + 1);
    }
    return counts;
  });

  function silenceOf(id: string): string | undefined {
    const view = master.view.value;
    const sinceMs = view && awaySinceMs(id, view.latest.problems, view.events);
    if (sinceMs === undefined) return undefined;
    const { digits, unit } = formatAge(view!.latest.nowMs - sinceMs);
    return `${digits} ${unit}`;
  }

  return computed(() =>
    clients.list.value
      ?.map((one): HereRow => {
        const isSelf = one.id === client.id;
        const isAway = one.state !== ClientState.ACTIVE;
        const context = {
          isSelf,
          modules: modules.value.get(one.id) ?? 0,
          silence: isAway ? silenceOf(one.id) : undefined,
        };
        return {
          client: one,
          player: markOf(one.id, one.name),
          fact: hereFact(one, context),
          isAway,
          isSelf,
        };
      })
      .sort((a, b) => Number(a.isAway) - Number(b.isAway)),
  );
}
