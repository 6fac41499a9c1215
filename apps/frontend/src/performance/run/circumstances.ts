import type { Connection } from '../../connection/connection.ts';
import { recordsPerSecond } from '../../connection/master-status.ts';
import { isAlive } from '../../sessions/state/session-state.ts';
import { formatNumber } from '../../ui/readouts/format-number.ts';
import { formatUptime } from '../../ui/readouts/format-time.ts';
import type { Circumstance } from '../results/test-result.ts';

/** Returns circumstances that may explain a figure: this browser, the master, and its current load. */
export function circumstances(
  { client, clients, sessions, master, state, roundTrip, name }: Connection,
  page: {
    readonly navigator: Pick<Navigator, 'userAgent' | 'hardwareConcurrency'>;
    readonly location: Pick<Location, 'origin'>;
  },
): Circumstance[] {
  const view = master.view.value;
  const latest = view?.latest;
  const version =
    latest?.version ?? (state.value.status === 'connected' ? state.value.masterVersion : undefined);
  const running = (sessions.list.value ?? []).filter(isAlive).length;
  const rate = recordsPerSecond(view);
  const all: readonly (readonly [key: string, label: string, value: string | undefined])[] = [
    ['browser', 'Browser', describeBrowser(page.navigator.userAgent)],
    ['cores', 'Cores of this computer', String(page.navigator.hardwareConcurrency)],
    ['client', 'This browser’s name', name.value],
    ['master', 'Master', latest?.name],
    ['master.address', 'Address of the master', page.location.origin],
    ['master.version', 'Version of the master', version],
    ['master.up', 'Uptime of the master', latest && formatUptime(latest.nowMs - latest.startedMs)],
    [
      'load.cpu',
      'CPU load of the master before the test',
      latest && `${formatNumber(latest.cpuPercent)} %`,
    ],
    [
      'load.records',
      'Records per second before the test',
      rate === undefined ? undefined : `${formatNumber(rate)} /s`,
    ],
    ['load.clients', 'Clients', String(clients.list.value?.length ?? 1)],
    ['load.sessions', 'Sessions running', String(running)],
    [
      'way',
      'Round trip to the master, p50',
      roundTrip.value && `${formatNumber(roundTrip.value.p50Ms, 1)} ms`,
    ],
    ['client.id', 'Client', client.id.slice(0, 8)],
  ];
  return all.flatMap(([key, label, value]) =>
    value === undefined || value === '' ? [] : [{ key, label, value }],
  );
}

/** Part of a user agent with the names and versions of browser and operating system. */
function describeBrowser(userAgent: string): string {
  const system = /\(([^)]*)\)/.exec(userAgent)?.[1] ?? '';
  const program =
    /(?:Edg|OPR|SamsungBrowser|Firefox|FxiOS|HeadlessChrome|Chrome|CriOS|Version)\/[\d.]+/.exec(
      userAgent,
    )?.[0] ?? userAgent.slice(0, 60);
  return system === '' ? program : `${program} on ${system}`;
}
