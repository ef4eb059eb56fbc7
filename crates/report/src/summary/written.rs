//! What every summary of a run can do once it is made: name its command, become text, and be written.

/// The functions of a summary that has an `origin`.
macro_rules! written {
    ($summary:ident) => {
        impl $summary {
            /// The same with the command line that it comes from.
            pub fn with_command(self, command: &str) -> Self {
                Self { origin: self.origin.by(command), ..self }
            }

            /// The object as text; a number that is not finite is an error that names its key.
            pub fn to_json(&self) -> std::io::Result<String> {
                $crate::number::to_json(self)
            }

            /// Writes summary.json.
            ///
            /// Fails with [`ReportError::Write`](crate::ReportError::Write) where the file cannot be written or a number is not finite.
            pub fn write(&self, dir: &std::path::Path) -> Result<std::path::PathBuf, $crate::ReportError> {
                $crate::file::write_summary(dir, self.to_json())
            }
        }
    };
}
pub(crate) use written;
