/** How to make a device trust this master. Strangers and plain HTTP reach it, too. */
export const CERTIFICATE_PATH = '/connect/certificate';
