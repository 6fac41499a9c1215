import { ServiceError } from '@ubii/proto';
import { ADMINS } from '../access/roles.ts';
import { definer, success } from './define-service.ts';

/** Opens the master to the local network, on the machine of the master alone. [AC-47] */
export const lanOpen = definer<'lan' | 'log' | 'settings'>()('lanOpen', {
  roles: ADMINS,
  auditObject: () => '',
  async handle({ lan, log, settings }, _payload, { isHere }) {
    if (lan.isOpen) return success('The local network can reach this master.');
    if (!isHere) {
      throw new ServiceError(
        'failed_precondition',
        'The local network can be turned on only from the machine that runs the master. Open this page there.',
      );
    }
    try {
      await lan.open();
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      throw new ServiceError(
        'unavailable',
        `The local network could not be turned on, and nothing has changed: ${reason}`,
      );
    }
    log.info('the local network can reach the master until it ends', {
      addresses: settings
        .endpoints()
        .addresses.map(({ url }) => url)
        .join(' '),
    });
    return success('The local network can reach this master until it ends.');
  },
});
