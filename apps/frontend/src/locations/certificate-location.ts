/** Path of the instructions for trusting this master; available without joining and over plain HTTP. */
export const CERTIFICATE_PATH = '/connect/certificate';
