import type { Init, Limit } from '@ubii/proto';
import { READERS } from '../access/roles.ts';
import { LIMITS, type LimitName } from '../limits/index.ts';
import { LIMIT_GROUPS } from '../limits/limit.ts';
import { LIMIT_USES, type LimitUseParts } from '../monitoring/limit-uses.ts';
import { definer } from './define-service.ts';

/** Lists the limits in force. [EX-35] */
export const limitList = definer<keyof LimitUseParts | 'limits' | 'limitWatch'>()('limitList', {
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
