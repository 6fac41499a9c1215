import { ServiceError } from '@ubii/proto';
import { ADMINS, READERS } from '../access/roles.ts';
import { readClientReport, type ClientReportParts } from '../monitoring/client-report.ts';
import { readMasterStatus, type StatusParts } from '../monitoring/master-status.ts';
import { definer } from './define-service.ts';
import { limitList } from './limits.ts';
import { requireElements } from './list-limits.ts';

const define = definer<keyof StatusParts | keyof ClientReportParts | 'logTail' | 'audit'>();

/** Services that say how the master is, and what was done to it. */
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
