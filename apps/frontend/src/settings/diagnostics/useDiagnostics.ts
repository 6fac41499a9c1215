import { LogLevel } from '@ubii/proto';
import { useConnection } from '../../connection/useConnection.ts';
import { saveFile } from '../../files/save-file.ts';
import { useThemeChoice } from '../../theme/useTheme.ts';
import { fetchLicences } from '../licences/licences.ts';
import { diagnosticsText } from './diagnostics.ts';

/** Saves a fault report as a file; while disconnected, with the data that is available. */
export function useDiagnostics(): () => Promise<void> {
  const { client, state, roundTrip, master, sessions, isConnected } = useConnection();
  const theme = useThemeChoice();

  /** Omits parts that fail: reports are made when things are broken. */
  const ask = async <R>(question: () => Promise<R>): Promise<R | undefined> =>
    isConnected.value ? question().catch(() => undefined) : undefined;

  return async () => {
    const nowMs = Date.now();
    const [settings, limits, tail, licences] = await Promise.all([
      ask(() => client.call('settingList')),
      ask(() => client.call('limitList')),
      ask(() => client.call('logTail', { level: LogLevel.LOG_DEBUG })),
      fetchLicences().catch(() => undefined),
    ]);
    const text = diagnosticsText({
      nowMs,
      page: {
        version: licences?.own.version,
        path: location.pathname,
        userAgent: navigator.userAgent,
        screen: `${innerWidth} x ${innerHeight} at ${devicePixelRatio}`,
        language: navigator.language,
        secure: isSecureContext,
        theme: theme.value,
      },
      connection: { state: state.value, roundTrip: roundTrip.value, counters: client.counters },
      status: master.view.value?.latest,
      settings,
      limits: limits?.elements,
      sessions: sessions.list.value,
      log: tail?.lines,
    });
    const moment = new Date(nowMs).toISOString().slice(0, 19).replaceAll(':', '-');
    saveFile({ name: `ubi-interact-diagnostics-${moment}.json`, text });
  };
}
