import type { ServiceName } from '@ubii/proto';

/** Location of the form for calling a service. */
export const callLocation = (service: ServiceName): string => `/calls/${service}`;
