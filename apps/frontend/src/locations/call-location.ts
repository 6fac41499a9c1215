import type { ServiceName } from '@ubii/proto';

/** Where a service is called. */
export const callLocation = (service: ServiceName): string => `/calls/${service}`;
