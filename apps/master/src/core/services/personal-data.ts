import { counted } from '@ubii/words';
import { ADMINS, READERS } from '../access/roles.ts';
import { definer } from './define-service.ts';

const define = definer<'personalLabels'>();

/** Services on personal data in recordings. */
export const PERSONAL_DATA_SERVICES = [
  // [PD-3]
  define('personalDataGet', {
    roles: READERS,
    handle: ({ personalLabels }) => personalLabels.get(),
  }),
  // [PD-4]
  define('personalDataSet', {
    roles: ADMINS,
    auditObject: (_core, { labels }) => counted(labels.length, 'label'),
    handle: ({ personalLabels }, data) => personalLabels.set(data),
  }),
];
