import { type Init, type Limit, ServiceError } from '@ubii/proto';
import { READERS, ADMINS } from '../access/roles.ts';
import { LIMITS, type LimitName } from '../limits/index.ts';
import { LIMIT_GROUPS } from '../limits/limit.ts';
import { LIMIT_USES, type LimitUseContext } from '../monitoring/limit-uses.ts';
import { definer } from './define-service.ts';
import { readClientReport, type ClientReportContext } from '../monitoring/client-report.ts';
import { readMasterStatus, type StatusContext } from '../monitoring/master-status.ts';
import { requireElements } from './list-limits.ts';

/** Lists the limits in force. [EX-35] */
const limitList = definer<keyof LimitUseContext | 'limits' | 'limitWatch'>()('limitList', {
  roles: READERS,
  handle(core) {
    const { limits, limitWatch } = core;
    const hits = new Map([...limitWatch.hits()].map(({ limit, streak }) => [limit, streak.count]));
    const groupIndex = (name: LimitName): number => LIMIT_GROUPS.indexOf(LIMITS[name].group);
    const names = (Object.keys(LIMITS) as LimitName[]).sort(
      (a, b) => groupIndex(a) - groupIndex(b),
    );
    const elements = names.map((name): Init<Limit> => {
      const { unit, reason, group } = LIMITS[name];
      const use = LIMIT_USES[name]?.(core);
      return {
        name,
        value: limits[name],
        unit,
        reason,
        group,
        hits: hits.get(name) ?? 0,
        ...(use !== undefined && { use }),
      };
    });
    return { elements };
  },
});

const define = definer<keyof StatusContext | keyof ClientReportContext | 'logTail' | 'audit'>();

/** Services on status, limits, log and audit of the master. */
export const MONITORING_SERVICES = [
  // [EX-16]
  define('masterStatus', {
    roles: READERS,
    handle: (core, { sinceMs }) => readMasterStatus(core, sinceMs),
  }),
  // [EX-25]
  define('clientReport', {
    roles: READERS,
    handle(core, wanted) {
      requireElements(core, wanted.clientIds);
      return readClientReport(core, wanted);
    },
    gather: (report, others) => ({
      ...report,
      clients: [...(report.clients ?? []), ...others.flatMap(({ clients }) => clients)],
    }),
  }),
  limitList,
  // [EX-37]
  define('logTail', {
    roles: ADMINS,
    handle({ logTail }, { cursor, level, count }) {
      if (count >= 0) return logTail.read(cursor, level, count);
      throw new ServiceError(
        'invalid_argument',
        `The member count is ${count}, but it is a number of lines, or 0 for all that are kept.`,
      );
    },
  }),
  // [EX-93]
  define('auditLog', { roles: ADMINS, handle: ({ audit }, wanted) => audit.read(wanted) }),
];
